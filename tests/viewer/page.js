// Draws each job of /files/jobs.json with three.js, and posts its pixels to /picture.
import * as THREE from 'three';
import {DRACOLoader} from 'three/addons/loaders/DRACOLoader.js';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

const draco = new DRACOLoader().setDecoderPath('/three/examples/jsm/libs/draco/gltf/');
const loader = new GLTFLoader().setDRACOLoader(draco);
const cameras = new Map();  // of a case: the first job that can be drawn decides

function post(path, body, information) {
  const headers = {'x-information': encodeURIComponent(JSON.stringify(information ?? null))};
  return fetch(path, {method: 'POST', body, headers});
}

function eachMaterial(object, visit) {
  object.traverse((node) => {
    if (!node.material) return;
    node.material = Array.isArray(node.material) ? node.material.map(visit) : visit(node.material);
  });
}

/** zstrip takes the nearest texel, whatever a sampler says. */
function takeNearestTexels(material) {
  for (const value of Object.values(material)) {
    if (!value?.isTexture) continue;
    value.minFilter = value.magFilter = THREE.NearestFilter;
    value.generateMipmaps = false;
    value.needsUpdate = true;
  }
  return material;
}

/** zstrip's model of light: diffuse alone. */
function toLambert(from) {
  if (!from.isMeshStandardMaterial) return from;
  const to = new THREE.MeshLambertMaterial();
  THREE.Material.prototype.copy.call(to, from);
  for (const name of ['map', 'emissiveMap', 'emissiveIntensity', 'flatShading']) to[name] = from[name];
  to.color.copy(from.color);
  to.emissive.copy(from.emissive);
  return to;
}

/** As near as the box's sphere allows. Numbers of few digits, which a command line takes, too. */
function placeCamera(job, object) {
  const box = new THREE.Box3().setFromObject(object, true);
  const size = box.getSize(new THREE.Vector3()).length();
  if (!Number.isFinite(size) || size === 0) throw new Error('there is nothing to draw');
  const direction = new THREE.Vector3(...job.from).normalize();
  const distance = (0.5 * size) / Math.sin((job.degrees * Math.PI) / 360);
  const round = (vector) => vector.toArray().map((c) => Number((Math.abs(c) < 1e-6 * size ? 0 : c).toPrecision(6)));
  const target = box.getCenter(new THREE.Vector3());
  return {eye: round(target.clone().addScaledVector(direction, distance)), target: round(target), distance, size};
}

function cameraOf(job, gltf, aspect) {
  if (job.camera !== undefined) {
    const camera = gltf.cameras[job.camera.index];
    if (!camera) throw new Error(`no camera ${job.camera.index}`);
    camera.aspect = aspect;
    camera.left = -camera.top * aspect;
    camera.right = camera.top * aspect;
    camera.updateProjectionMatrix();
    return {camera, placed: null};
  }
  if (!cameras.has(job.case)) cameras.set(job.case, placeCamera(job, gltf.scene));
  const placed = cameras.get(job.case);
  const nearest = Math.max(placed.distance - placed.size, placed.distance * 0.01);
  const camera = new THREE.PerspectiveCamera(job.degrees, aspect, nearest, placed.distance + placed.size);
  camera.position.fromArray(placed.eye);
  camera.lookAt(...placed.target);
  return {camera, placed};
}

/** Lambert's reflection divides by pi, zstrip's does not. */
function addLights(scene, lights) {
  for (const light of lights) {
    const grey = new THREE.Color().setScalar(1);
    if (!light.towards) {
      scene.add(new THREE.AmbientLight(grey, Math.PI * light.share));
      continue;
    }
    const directional = new THREE.DirectionalLight(grey, Math.PI * light.share);
    directional.position.fromArray(light.towards);
    scene.add(directional, directional.target);
  }
}

function pose(gltf, part) {
  if (gltf.animations.length === 0) return;
  const mixer = new THREE.AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations[0]).play();
  mixer.setTime(part * gltf.animations[0].duration);
}

function pixelsOf(renderer, width, height) {
  const gl = renderer.getContext();
  const upwards = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upwards);
  const pixels = new Uint8Array(upwards.length);
  for (let y = 0; y < height; ++y) {
    pixels.set(upwards.subarray((height - 1 - y) * width * 4, (height - y) * width * 4), y * width * 4);
  }
  return pixels;
}

async function draw(renderer, job) {
  const [width, height] = job.size;
  const gltf = await loader.loadAsync(job.url);
  pose(gltf, job.time);
  eachMaterial(gltf.scene, takeNearestTexels);
  if (job.lambert) eachMaterial(gltf.scene, toLambert);
  const scene = new THREE.Scene();
  scene.add(gltf.scene);
  addLights(scene, job.lights);
  scene.updateMatrixWorld(true);
  const {camera, placed} = cameraOf(job, gltf, width / height);
  renderer.setSize(width, height, false);
  renderer.setClearColor(0x000000, 0);
  renderer.outputColorSpace = job.linear ? THREE.LinearSRGBColorSpace : THREE.SRGBColorSpace;
  renderer.render(scene, camera);
  const pixels = pixelsOf(renderer, width, height);
  const {triangles, lines, points} = renderer.info.render;
  eachMaterial(gltf.scene, (material) => (material.dispose(), material));
  return {pixels, information: {id: job.id, placed, triangles, lines, points}};
}

async function main() {
  const jobs = await (await fetch('/files/jobs.json')).json();
  const canvas = document.createElement('canvas');
  const renderer = new THREE.WebGLRenderer({canvas, alpha: true, antialias: false, preserveDrawingBuffer: true});
  for (const job of jobs) {
    try {
      const {pixels, information} = await draw(renderer, job);
      await post('/picture', pixels, information);
    } catch (error) {
      await post('/picture', new Uint8Array(), {id: job.id, error: String(error?.message ?? error)});
    }
  }
  await post('/done');
}

main().catch((error) => post('/failed', String(error?.stack ?? error)));
