//! calls FIGURE.zsc ROOM.zsc X Y: the crate's functions on baked scenes. Prints what pixel X, Y of the room shows; a call
//! that does not do what its documentation says is a panic.
use std::{env, fs};

use zstrip::{Area, Error, FitOptions, Format, Player};

const WIDTH: u16 = 96;
const HEIGHT: u16 = 80;

fn scene(path: &str) -> &'static [u8] {
    let file = fs::read(path).expect(path);
    let words = Vec::leak(vec![0u32; file.len() / 4 + 1]);
    let bytes = unsafe { std::slice::from_raw_parts_mut(words.as_mut_ptr().cast::<u8>(), file.len()) };
    bytes.copy_from_slice(&file);
    bytes
}

fn frame(player: &mut Player) -> Vec<u8> {
    let mut pixels = Vec::new();
    player.draw(|strip| pixels.extend_from_slice(strip.pixels)).expect("a frame");
    assert_eq!(pixels.len(), 2 * usize::from(WIDTH) * usize::from(HEIGHT));
    pixels
}

fn says(result: Result<(), Error>, words: &str) {
    let message = result.expect_err(words).to_string();
    assert!(message.contains(words), "{} does not say {}", message, words);
}

fn faults_are_values(figure: &'static [u8]) {
    says(Player::new(&mut [0; 16]).map(|_| ()), "too little");
    let mut memory = vec![0; 4096];
    let mut player = Player::new(&mut memory).expect("a player");
    says(player.begin(), "open");
    says(player.strip(0).map(|_| ()), "open");
    says(player.pick(0, 0).map(|_| ()), "open");
    says(player.open(&figure[4..figure.len() - 4]), "no whole scene");
    says(player.open(&figure[1..]), "multiple of 4");
    says(player.open(figure), "bytes of memory are missing");

    let mut memory = vec![0; 1 << 18];
    let mut player = Player::new(&mut memory[1..]).expect("a player");
    player.open(figure).expect("a scene");
    says(player.fit(0, 0, Format::Rgb565, &FitOptions::default()), "samples a side");
    says(player.strip(0).map(|_| ()), "fit");
    says(player.play_clip(2, 0, true), "clip");
    player.fit(WIDTH, HEIGHT, Format::Rgb565, &FitOptions::default()).expect("a plan");
    says(player.strip(HEIGHT).map(|_| ()), "strip");
    says(player.strip(u16::MAX).map(|_| ()), "strip");
    says(player.pick(WIDTH, 0).map(|_| ()), "picture");
    let whole = Area { left: 0, top: 0, width: WIDTH, height: HEIGHT };
    says(player.draw_area(whole, &mut [0; 100], 2 * usize::from(WIDTH), None), "bytes");
    let mut pixels = vec![0; 2 * usize::from(WIDTH) * usize::from(HEIGHT)];
    says(player.draw_area(whole, &mut pixels, 2 * usize::from(WIDTH), Some((&mut [0; 9], 4))), "mask");
}

/// The end of a fade from one clip is the other clip, at its time.
fn clips_fade(figure: &'static [u8]) {
    let mut memories = [vec![0; 1 << 18], vec![0; 1 << 18]];
    let [one, other] = &mut memories;
    let mut players = [Player::new(one).expect("a player"), Player::new(other).expect("a player")];
    for player in &mut players {
        player.open(figure).expect("a scene");
        player.fit(WIDTH, HEIGHT, Format::Rgb565, &FitOptions::default()).expect("a plan");
    }
    let [faded, plain] = &mut players;
    let clips: Vec<(String, u32)> = faded.clips().map(|clip| (clip.name.to_string(), clip.milliseconds)).collect();
    assert_eq!(clips, [("walk".to_string(), 1200), ("wave".to_string(), 1500)]);
    assert_eq!(faded.find_clip("run"), None);
    assert_eq!(faded.poll_event(), None, "the clip has no events");
    let wave = faded.find_clip("wave").expect("a clip");
    faded.play(1000);
    faded.play(1250);
    assert_eq!(faded.time(), 250);
    faded.play_clip(wave, 400, true).expect("a fade");
    plain.play_clip(wave, 0, true).expect("a clip");
    faded.play(1450);
    plain.play(0);
    plain.play(200);
    assert_eq!((faded.time(), faded.period(), plain.time()), (200, 1500, 200));
    assert_ne!(frame(faded), frame(plain), "a fade shows both clips");
    faded.play(1700);
    plain.play(450);
    assert_eq!(frame(faded), frame(plain), "after the fade");

    plain.play_clip(wave, 0, false).expect("a clip");
    plain.play(5000);
    assert_eq!(plain.time(), 1499, "a clip that does not loop stops at its end");
    plain.hold(true);
    plain.seek(300);
    plain.play(6000);
    assert_eq!(plain.time(), 300, "held");
}

fn the_camera_moves(room: &'static [u8]) {
    let mut memory = vec![0; 1 << 18];
    let mut player = Player::new(&mut memory).expect("a player");
    player.open(room).expect("a scene");
    let options = FitOptions { strip_rows: 7, masked: true, tracks_changes: true, ..FitOptions::default() };
    player.fit(WIDTH, HEIGHT, Format::Rgb565, &options).expect("a plan");
    assert_eq!(player.changed(), Some(Area { left: 0, top: 0, width: WIDTH, height: HEIGHT }));
    let baked = frame(&mut player);
    assert_eq!(player.changed(), None);
    player.orbit(4096, 1024);
    player.zoom(120);
    let moved = frame(&mut player);
    assert_ne!(baked, moved);
    assert!(player.changed().is_some());

    // A rectangle has the pixels of the strips, and the mask of them.
    let area = Area { left: 5, top: 3, width: 40, height: 30 };
    let (mut pixels, mut mask) = (vec![0; 100 * 30], vec![1; 50 * 29 + 40]);
    player.draw_area(area, &mut pixels, 100, Some((&mut mask, 50))).expect("a rectangle");
    for y in 0..30 {
        let from = 2 * (usize::from(WIDTH) * (y + 3) + 5);
        assert_eq!(pixels[100 * y..100 * y + 80], moved[from..from + 80], "row {}", y);
        let strip = player.strip((y + 3) as u16).expect("a strip");
        let from = usize::from(WIDTH) * (y + 3 - usize::from(strip.area.top)) + 5;
        assert_eq!(mask[50 * y..50 * y + 40], strip.mask.expect("a mask")[from..from + 40], "row {}", y);
    }
    assert!(mask.contains(&255));

    player.orbit(0, 0);
    player.zoom(100);
    assert_eq!(frame(&mut player), baked);
    player.background(Some(0x102030));
    player.show_text("longer than twenty-four bytes");
    assert_ne!(frame(&mut player), baked);
    player.background(None);
    player.show_text("");
    assert_eq!(frame(&mut player), baked);
}

fn main() {
    let arguments: Vec<String> = env::args().collect();
    let (figure, room) = (scene(&arguments[1]), scene(&arguments[2]));
    faults_are_values(figure);
    clips_fade(figure);
    the_camera_moves(room);

    let mut memory = vec![0; 1 << 18];
    let mut player = Player::new(&mut memory).expect("a player");
    player.open(room).expect("a scene");
    player.fit(160, 120, Format::Rgb565, &FitOptions::default()).expect("a plan");
    let picked = player.pick(arguments[3].parse().unwrap(), arguments[4].parse().unwrap()).expect("a pick");
    println!("{:?} {} {} {}", picked.shown, picked.index, picked.triangle, picked.texture.is_some());
}
