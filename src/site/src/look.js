// What surfaces look like: matt, with edges drawn where faces meet at an angle, and round things in two tones, so that
// their turning is seen.
import * as THREE from "three";

const CREASE = Math.cos((30 * Math.PI) / 180); // faces that meet at less look round
const FAR = 1e3; // radii: no edge is near

/** Rim: to a corner's three edges, in radii of the shape, and a number whose sign is the tone.
 *  A corner has the distance to the edge across from it and 0 for its own two, so that in between each is linear. */
function withRim(geometry, rim) {
  geometry.setAttribute("rim", new THREE.BufferAttribute(rim, 4));
  return geometry;
}

/** A ball or the like: smooth, its eight octants in two tones.   @param scale [3] m, half its extents */
export function round(geometry, scale) {
  const { position } = geometry.attributes,
    rim = new Float32Array(4 * position.count).fill(FAR);
  for (let i = 0; i < position.count; ++i)
    rim[4 * i + 3] = (position.getX(i) * position.getY(i) * position.getZ(i)) / (scale[0] * scale[1] * scale[2]);
  return withRim(geometry, rim);
}

/** What rolls about its own y: its four quarters in two tones.   @param radius m */
export function quartered(geometry, radius) {
  const { position, rim } = geometry.attributes;
  for (let i = 0; i < position.count; ++i) rim.setW(i, (position.getX(i) * position.getZ(i)) / radius ** 2);
  return geometry;
}

/** No edges: a mesh for the eye. */
export function plain(geometry) {
  geometry.computeVertexNormals();
  return withRim(geometry, new Float32Array(4 * geometry.attributes.position.count).fill(FAR));
}

/** Faces that meet at less than the crease share normals; at others there is an edge.   @param drawn  are edges? */
export function creased(indexed, drawn = true) {
  const geometry = indexed.index ? indexed.toNonIndexed() : indexed,
    { array } = geometry.attributes.position,
    corners = array.length / 3;
  geometry.computeBoundingSphere();
  const { radius } = geometry.boundingSphere,
    grain = 1e5 / radius;
  const names = new Map(),
    same = new Uint32Array(corners); // corners at one place have one number
  for (let i = 0; i < corners; ++i) {
    const name = `${Math.round(array[3 * i] * grain)},${Math.round(array[3 * i + 1] * grain)},${Math.round(array[3 * i + 2] * grain)}`;
    if (!names.has(name)) names.set(name, names.size);
    same[i] = names.get(name);
  }
  const at = (i) => new THREE.Vector3().fromArray(array, 3 * i),
    faces = [],
    around = Array.from(names, () => []),
    edges = new Map();
  for (let i = 0; i < corners; i += 3) {
    const [a, b, c] = [at(i), at(i + 1), at(i + 2)],
      normal = b.clone().sub(a).cross(c.clone().sub(a)),
      face = { normal: normal.clone().normalize(), area: normal };
    faces.push(face);
    for (let k = 0; k < 3; ++k) {
      around[same[i + k]].push(face);
      const ends = [same[i + ((k + 1) % 3)], same[i + ((k + 2) % 3)]].sort((x, y) => x - y).join();
      edges.set(ends, [...(edges.get(ends) ?? []), face]);
    }
  }
  const normals = new Float32Array(array.length),
    rim = new Float32Array(4 * corners).fill(FAR),
    sum = new THREE.Vector3();
  for (let i = 0; i < corners; ++i) {
    const first = i - (i % 3),
      face = faces[first / 3];
    sum.set(0, 0, 0);
    for (const other of around[same[i]]) if (other.normal.dot(face.normal) > CREASE) sum.add(other.area);
    sum.normalize().toArray(normals, 3 * i);
    const ends = [first + ((i + 1) % 3), first + ((i + 2) % 3)],
      pair = edges.get([same[ends[0]], same[ends[1]]].sort((x, y) => x - y).join());
    if (!drawn || (pair.length === 2 && pair[0].normal.dot(pair[1].normal) > CREASE)) continue;
    const [p, q] = ends.map(at),
      height = new THREE.Line3(p, q).closestPointToPoint(at(i), false, new THREE.Vector3()).distanceTo(at(i));
    for (let k = 0; k < 3; ++k) rim[4 * (first + k) + (i % 3)] = first + k === i ? height / radius : 0;
  }
  geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
  geometry.deleteAttribute("uv");
  return withRim(geometry, rim);
}

/** Shared by all materials: is there time for soft shadows? The grid of the ground, and where up is. */
export const common = {
  soft: { value: 1 },
  spacing: { value: 1 },
  line: { value: 1 },
  up: { value: new THREE.Vector3(0, 1, 0) },
};

// Light is computed at corners and only dimmed by shadows between them: where the processor draws, pixels are what costs.
const VERTEX = `
#include <common>
#include <fog_pars_vertex>
#include <shadowmap_pars_vertex>
#include <lights_pars_begin>
varying vec3 vDim, vSun;
PARS
void main() {
  #include <beginnormal_vertex>
  #include <defaultnormal_vertex>
  #include <begin_vertex>
  #include <project_vertex>
  #include <worldpos_vertex>
  #include <shadowmap_vertex>
  #include <fog_vertex>
  vec3 n = normalize(transformedNormal), base = tint * RECIPROCAL_PI;
  #ifdef USE_INSTANCING_COLOR
  base *= instanceColor.rgb;
  #endif
  vDim = base * getHemisphereLightIrradiance(hemisphereLights[0], n);
  vSun = base * directionalLights[0].color * max(0.0, dot(n, directionalLights[0].direction));
  MAIN
}`;
const FRAGMENT = `
#include <common>
#include <fog_pars_fragment>
#include <shadowmap_pars_fragment>
varying vec3 vDim, vSun;
uniform float soft;
PARS
float lit() {
  vec3 at = vDirectionalShadowCoord[0].xyz / vDirectionalShadowCoord[0].w;
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
  at.z += directionalLightShadows[0].shadowBias;
  float sum = texture(directionalShadowMap[0], at);
  if (soft == 0.0) return sum;
  vec2 texel = soft / directionalLightShadows[0].shadowMapSize;
  for (int k = 0; k < 8; ++k) {
    float turn = float(k) * 2.399963;
    sum += texture(directionalShadowMap[0], at + vec3(vec2(cos(turn), sin(turn)) * texel * sqrt(float(k + 1)), 0.0));
  }
  return sum / 9.0;
}
void main() {
  vec3 colour = vDim + vSun * lit();
  MAIN
  gl_FragColor.rgb = sqrt(gl_FragColor.rgb); // near enough to sRGB, and cheap
  #include <fog_fragment>
}`;

function material({ tint = "#ffffff", uniforms = {}, vertex, fragment, ...options }) {
  const filled = (text, [pars, main]) => text.replace("PARS", pars).replace("MAIN", main);
  return new THREE.ShaderMaterial({
    lights: true,
    fog: true,
    uniforms: {
      ...THREE.UniformsUtils.clone(THREE.UniformsUtils.merge([THREE.UniformsLib.lights, THREE.UniformsLib.fog])),
      ...uniforms,
      soft: common.soft,
      tint: { value: new THREE.Color(tint) },
    },
    vertexShader: filled(VERTEX, [`uniform vec3 tint;\n${vertex[0]}`, vertex[1]]),
    fragmentShader: filled(FRAGMENT, fragment),
    ...options,
  });
}

/** Of bodies. A line is a pixel or two wide, and fades where a body is small. */
export const bodyMaterial = (options) =>
  material({
    vertex: ["attribute vec4 rim; varying vec4 vRim;", "vRim = rim;"],
    fragment: [
      "varying vec4 vRim;",
      `vec4 pixel = fwidth(vRim) + 1e-9;
      vec3 off = vRim.xyz / pixel.xyz;
      float finest = max(pixel.x, max(pixel.y, pixel.z));
      float line = (1.0 - smoothstep(0.5, 1.5, min(off.x, min(off.y, off.z)))) * (1.0 - smoothstep(0.03, 0.2, finest));
      float tone = mix(0.6, 1.0, smoothstep(-0.7, 0.7, vRim.w / pixel.w));
      gl_FragColor = vec4(colour * tone * (1.0 - 0.65 * line), 1.0);`,
    ],
    ...options,
  });

/** Level ground to the horizon: lines of a grid, which fade with the distance. */
export const groundMaterial = () =>
  material({
    uniforms: { spacing: common.spacing, line: common.line, up: common.up },
    vertex: [
      "varying vec2 vCell; uniform float spacing; uniform vec3 up;",
      "vCell = (up.y > 0.5 ? worldPosition.xz : up.z > 0.5 ? worldPosition.xy : worldPosition.yz) / spacing;",
    ],
    fragment: [
      "varying vec2 vCell; uniform float line;",
      `vec2 width = fwidth(vCell);
      vec2 off = abs(fract(vCell - 0.5) - 0.5) / width;
      float here = (1.0 - smoothstep(0.2, 1.1, min(off.x, off.y))) * (1.0 - smoothstep(0.05, 0.3, max(width.x, width.y)));
      gl_FragColor = vec4(colour * mix(1.0, line, here), 1.0);`,
    ],
  });

/** The sky behind all: from the horizon's colour up, and down.   @param uniforms  high, horizon */
export function skyDome(uniforms) {
  const dome = new THREE.Mesh(
    new THREE.SphereGeometry(1, 16, 24),
    new THREE.ShaderMaterial({
      uniforms,
      side: THREE.BackSide,
      depthWrite: false,
      vertexShader: `uniform vec3 high; uniform vec3 horizon; varying vec3 colour;
        void main() {
          colour = sqrt(mix(horizon, high, smoothstep(0.0, 0.5, abs(position.y))));
          gl_Position = (projectionMatrix * modelViewMatrix * vec4(position, 1.0)).xyww;
        }`,
      fragmentShader: "varying vec3 colour; void main() { gl_FragColor = vec4(colour, 1.0); }",
    }),
  );
  dome.frustumCulled = false;
  dome.renderOrder = 1; // after what hides it
  return dome;
}
