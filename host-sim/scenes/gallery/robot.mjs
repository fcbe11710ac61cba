// Makes the models of robot.toml. Public domain. Run: node robot.mjs
import {joined, occluded, welded, writeModel} from './models.mjs';
import {ball, box, covered, lathe, mix, placed, polygon, tube} from './shapes.mjs';

const kBody = '#f0a828', kLight = '#f8dc98', kDark = '#39404e', kSteel = '#98a4b4', kRed = '#e0503c';

// The origin of each part is the joint about which it rotates. The robot looks along +z, its own left is +x.
const face =
    polygon([[-0.42, -0.24, 0.465], [0.42, -0.24, 0.465], [0.42, 0.26, 0.465], [-0.42, 0.26, 0.465]], '#202838');
const eye = (x) => placed(
    polygon(
        Array.from({length: 8}, (_, i) => [0.1 * Math.cos(Math.PI * i / 4), 0.12 * Math.sin(Math.PI * i / 4), 0]),
        '#80f4ff'),
    {at: [x, 0.06, 0.48]});
const mouth =
    polygon([[-0.12, -0.13, 0.48], [0.12, -0.13, 0.48], [0.15, -0.09, 0.48], [-0.15, -0.09, 0.48]], '#80f4ff');
const head = [
  ...box([1.1, 0.78, 0.9], kBody, 0.1),
  ...[1, -1].flatMap(
      (s) =>
          placed(lathe([[0, 0.1], [0.14, 0.1], [0.17, 0]], 7, kSteel), {turn: [0, 0, -90 * s], at: [0.55 * s, 0, 0]})),
  ...placed(lathe([[0.03, 0.26], [0.03, 0]], 3, kDark), {at: [0, 0.39, 0]}),
  ...placed(ball(0.1, 4, 6, kRed), {at: [0, 0.7, 0]}),
];
// A box in what is above it.
const hung = (size, colour) => covered(box(size, colour), ([, y]) => y > 0);
const chest = [
  ...box([0.9, 0.8, 0.62], kBody, 0.09),
  ...placed(lathe([[0.14, 0.16], [0.14, 0]], 7, kDark), {at: [0, 0.38, 0]}),
  ...polygon([[-0.26, -0.16, 0.325], [0.26, -0.16, 0.325], [0.26, 0.2, 0.325], [-0.26, 0.2, 0.325]], kLight),
  ...placed(hung([0.66, 0.2, 0.46], kDark), {at: [0, -0.46, 0]}),
];
const lamps = [[-0.14, kRed], [0, '#f4d040'], [0.14, '#58c070']].flatMap(
    ([x, colour]) => polygon(
        [[x - 0.05, 0.06, 0.34], [x + 0.05, 0.06, 0.34], [x + 0.05, 0.15, 0.34], [x - 0.05, 0.15, 0.34]], colour));
// An arm looks the same from the front and from the back, so that rotating it by 180 degrees makes the other arm.
const arm = [
  ...ball(0.17, 4, 6, kSteel),
  ...tube([[0.02, -0.08, 0], [0.1, -0.28, 0], [0.12, -0.56, 0]], 0.085, 6, kDark),
  ...placed(box([0.22, 0.26, 0.26], kBody, 0.06), {at: [0.12, -0.62, 0]}),
  ...placed(hung([0.12, 0.14, 0.1], kSteel), {at: [0.12, -0.8, 0]}),
];
const leg = [
  ...tube([[0, 0.02, 0], [0, -0.42, 0]], 0.12, 7, kDark),
  ...placed(box([0.28, 0.16, 0.28], kSteel, 0.04), {at: [0, -0.24, 0]}),
  ...placed(box([0.36, 0.2, 0.54], kBody, 0.06), {at: [0, -0.5, 0.08]}),
];
const shaded = (faces, others) => occluded(welded(faces, 75), {others, reach: 0.8, dark: [0.42, 0.4, 0.46]});
const whole = [
  ...placed(chest, {at: [0, 1.15, 0]}), ...placed(head, {at: [0, 2.05, 0.04]}), ...placed(arm, {at: [0.57, 1.4, 0]}),
  ...placed(arm, {at: [-0.57, 1.4, 0], turn: [0, 180, 0]}), ...placed(leg, {at: [0.24, 0.6, 0]}),
  ...placed(leg, {at: [-0.24, 0.6, 0]})
];
const around = (x, y, z) => placed(whole, {at: [-x, -y, -z]});
writeModel('robot/head.glb', {
  metal: joined(shaded(head, around(0, 2.05, 0.04)), welded(face)),
  screen: welded([...eye(0.2), ...eye(-0.2), ...mouth])
});
writeModel('robot/chest.glb', {metal: joined(shaded(chest, around(0, 1.15, 0)), welded(lamps))});
writeModel('robot/arm.glb', {metal: shaded(arm, around(0.57, 1.4, 0))});
writeModel('robot/leg.glb', {metal: shaded(leg, around(0.24, 0.6, 0))});

// The floor: a plane and the joints of its tiles. Those across are wider and paler the farther they are, so that none
// is lower than a pixel: robot.toml puts the eye at kEye, and 1 is kFocal pixels large at distance 1. Nearer ones are
// below the picture.
const kFloor = '#b4d4de', kJoint = '#88b0c4', kEye = [3.3, 5.8, 7.7], kFocal = 647;
const strip = (x0, x1, z0, z1, y, colour) => polygon([[x0, y, z1], [x1, y, z1], [x1, y, z0], [x0, y, z0]], colour);
const joints = [];
for (let x = -4; x <= 2; ++x) joints.push(...strip(x - 0.03, x + 0.03, -11, 4, 0.02, kJoint));
for (let z = -10; z <= 2; ++z) {
  const pixels = 0.06 * kFocal * kEye[1] / (kEye[0] ** 2 + kEye[1] ** 2 + (kEye[2] - z) ** 2);
  const wider = Math.max(1, 1.3 / pixels);
  joints.push(...strip(-8, 8, z - 0.03 * wider, z + 0.03 * wider, 0.02, mix(kFloor, kJoint, 1 / wider)));
}
writeModel('robot/floor.glb', {floor: welded([...strip(-14, 14, -14, 14, 0, kFloor), ...joints])});
