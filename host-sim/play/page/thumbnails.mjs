// The strip of examples, each with a small picture that was drawn when the page was built.

const strip = document.getElementById('thumbnails');

/** Returns a function that fetches the pictures, for when there is time. */
export function makeThumbnails(examples, chosen) {
  const images = new Map();
  for (const {scene, title, thumbnail} of examples) {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.scene = scene;
    button.title = title;
    const name = document.createElement('span');
    name.textContent = title.split(':')[0].replaceAll('_', ' ');
    if (thumbnail) {
      const image = new Image(96, 96);
      Object.assign(image, {alt: '', loading: 'lazy'});
      images.set(image, thumbnail);
      button.append(image);
    }
    button.append(name);
    button.addEventListener('click', () => chosen(scene));
    strip.append(button);
  }
  return () => images.forEach((source, image) => { image.src = source; });
}

/** Marks the scene that is shown. */
export function showChosen(scene) {
  for (const button of strip.children) {
    const is = button.dataset.scene === scene;
    button.setAttribute('aria-pressed', String(is));
    if (!is) continue;
    // scrollIntoView() would scroll the page, too.
    strip.scrollTo({left: button.offsetLeft - (strip.clientWidth - button.offsetWidth) / 2, behavior: 'smooth'});
  }
}
