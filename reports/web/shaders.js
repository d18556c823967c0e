// What is computed of each corner and each pixel. A triangle has one light: its normal comes from the picture itself.

const CORNER_SHADER = `#version 300 es
layout(location = 0) in vec3 place;   // of its box, 0 to 1
layout(location = 1) in float value;  // the number of a colour, over 65535
uniform vec3 origin, size;
uniform mat4 pose, view;
out vec3 x;
out vec3 side;
flat out int colour;
void main() {
  x = (pose * vec4(origin + size * place, 1.0)).xyz;
  side = vec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2)));
  colour = int(value * 65535.0 + 0.5);
  gl_Position = view * vec4(x, 1.0);
}`;

const PIXEL_SHADER = `#version 300 es
precision highp float;
precision highp sampler2D;
in vec3 x;
in vec3 side;
flat in int colour;
uniform sampler2D colours;
uniform vec3 right, up, toward;  // of the eye
uniform vec4 plane;              // of the section: nothing is shown beyond it
uniform vec2 depths;             // m, of the ends of the ramp; equal: the triangle's own colour
uniform bool lines;
out vec4 shown;
void main() {
  float beyond = dot(plane.xyz, x) - plane.w;
  if (beyond > 0.0) discard;
  vec3 n = normalize(cross(dFdx(x), dFdy(x)));
  n *= sign(dot(n, toward) + 1e-9);
  float key = max(dot(n, normalize(-0.55 * right + 0.65 * up + 0.75 * toward)), 0.0);
  float fill = max(dot(n, normalize(0.8 * right - 0.1 * up + 0.5 * toward)), 0.0);
  int k = colour;
  if (depths.x != depths.y) k = int(clamp((x.z - depths.x) / (depths.y - depths.x), 0.0, 1.0) * 255.0 + 0.5);
  vec3 own = gl_FrontFacing || dot(plane.xyz, plane.xyz) == 0.0 ? texelFetch(colours, ivec2(k % 256, k / 256), 0).rgb : vec3(0.56, 0.50, 0.43);
  float light = 0.42 + 0.56 * key + 0.20 * fill;
  if (lines) {
    vec3 grows = fwidth(side), near = side / grows;  // small triangles have paler lines, or nothing else were seen
    float strength = clamp(0.8 - 2.0 * max(grows.x, max(grows.y, grows.z)), 0.15, 0.6);
    light *= 1.0 - strength * clamp(1.3 - min(near.x, min(near.y, near.z)), 0.0, 1.0);
  }
  if (-beyond < 1.5 * fwidth(beyond)) { own = vec3(0.80, 0.15, 0.10); light = 1.0; }
  shown = vec4(min(own * light, 1.0), 1.0);
}`;

function compiled(gl, kind, source) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) || "the shader does not compile");
  return shader;
}

// The program and the places of its uniforms.
function drawingProgram(gl) {
  const program = gl.createProgram(), at = {};
  gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, CORNER_SHADER));
  gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, PIXEL_SHADER));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) || "the program does not link");
  for (const name of ["origin", "size", "pose", "view", "colours", "right", "up", "toward", "plane", "depths", "lines"])
    at[name] = gl.getUniformLocation(program, name);
  return {program, at};
}
