// The interactive view of a report: one canvas, WebGL 1, no dependency. Data comes from the element #surfaces.
"use strict";
(() => {
  const $ = (id) => document.getElementById(id);
  const data = JSON.parse($("surfaces").textContent);
  const root = document.documentElement;

  $("theme").addEventListener("click", () => {
    const dark = isDark();
    root.dataset.theme = dark ? "light" : "dark";
    draw();
  });
  const isDark = () =>
    root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw());

  let draw = () => {};
  if (!data) return;
  const canvas = $("view");
  const gl = canvas.getContext("webgl", { antialias: true, alpha: true, premultipliedAlpha: true });
  if (!gl) {
    $("no-webgl").hidden = false;
    $("stage").hidden = true;
    return;
  }

  // ---- data ------------------------------------------------------------------------------------------------------
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const floats = (text) => new Float32Array(bytes(text).buffer);
  const NONE = 1e9; // a vertex without a value
  const FOCAL = 1 / Math.tan(0.25);
  const RIBBON = 14; // numbers of a corner of a ribbon
  const SWING = 0.2; // how far a mode swings, in units of the radius of the scene

  const places = (text) => new Uint16Array(bytes(text).buffer);

  // The triangles of a surface, and every fourth line of its grids.
  function grid(surface) {
    const faces = [], wires = [];
    const line = (points) => points.slice(1).forEach((p, k) => wires.push(points[k], p));
    const range = (n) => Array.from({ length: n + 1 }, (_, k) => k);
    for (const chart of surface.charts) {
      const [nu, nv] = chart.steps, own = chart.places && places(chart.places);
      const place = chart.triangle
        ? (a, b) => a * (nu + 1) - (a * (a - 1)) / 2 + b
        : (a, b) => a * (nv + 1) + b;
      const at = own ? (a, b) => own[place(a, b)] : place, first = faces.length;
      if (chart.triangle) {
        for (let a = 0; a < nu; a++)
          for (let b = 0; b < nu - a; b++) {
            faces.push(at(a, b), at(a + 1, b), at(a, b + 1));
            if (a + b + 2 <= nu) faces.push(at(a + 1, b), at(a + 1, b + 1), at(a, b + 1));
          }
        for (let k = 4; k < nu; k += 4) {
          line(range(nu - k).map((b) => at(k, b)));
          line(range(nu - k).map((a) => at(a, k)));
          line(range(nu - k).map((a) => at(a, nu - k - a)));
        }
      } else {
        for (let a = 0; a < nu; a++)
          for (let b = 0; b < nv; b++)
            faces.push(at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b), at(a + 1, b + 1), at(a, b + 1));
        for (let a = 4; a < nu; a += 4) line(range(nv).map((b) => at(a, b)));
        for (let b = 4; b < nv; b += 4) line(range(nu).map((a) => at(a, b)));
      }
      // All faces of a side that has two look to the same.
      if (chart.flipped)
        for (let f = first; f < faces.length; f += 3) [faces[f + 1], faces[f + 2]] = [faces[f + 2], faces[f + 1]];
    }
    return { faces: new Uint16Array(faces), wires };
  }

  // The segments of the lines of one kind.
  function segments(surface, kind) {
    const pairs = [];
    for (const line of surface.lines.filter((line) => line.kind === kind))
      places(line.points).forEach((p, k, all) => k && pairs.push(all[k - 1], p));
    return pairs;
  }

  // Lines of a net as segments between points of their own, cut off beyond a ball about the middle of the scene.
  const REACH = 3;
  function clipped(points, pairs) {
    const out = [];
    for (let s = 0; s < pairs.length; s += 2) {
      const [p, q] = [pairs[s], pairs[s + 1]].map((k) => [points[3 * k], points[3 * k + 1], points[3 * k + 2]]);
      const d = p.map((x, k) => q[k] - x), dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      const [a, b, c] = [dot(d, d), dot(p, d), dot(p, p) - REACH * REACH], root = b * b - a * c;
      if (!(root > 0) || !a) continue;
      const from = Math.max(0, (-b - Math.sqrt(root)) / a), to = Math.min(1, (-b + Math.sqrt(root)) / a);
      if (from < to) for (const t of [from, to]) out.push(...p.map((x, k) => x + t * d[k]));
    }
    return { points: out, pairs: Array.from({ length: out.length / 3 }, (_, k) => k) };
  }

  function normals(points, faces) {
    const sum = new Float32Array(points.length);
    for (let f = 0; f < faces.length; f += 3) {
      const [a, b, c] = [faces[f] * 3, faces[f + 1] * 3, faces[f + 2] * 3];
      const e = [0, 1, 2].map((k) => points[b + k] - points[a + k]);
      const g = [0, 1, 2].map((k) => points[c + k] - points[a + k]);
      const n = [e[1] * g[2] - e[2] * g[1], e[2] * g[0] - e[0] * g[2], e[0] * g[1] - e[1] * g[0]];
      for (const v of [a, b, c]) for (let k = 0; k < 3; k++) sum[v + k] += n[k];
    }
    for (let v = 0; v < sum.length; v += 3) {
      const length = Math.hypot(sum[v], sum[v + 1], sum[v + 2]) || 1;
      for (let k = 0; k < 3; k++) sum[v + k] /= length;
    }
    return sum;
  }

  // How far the points swing by a mode whose largest displacement is 1.
  function swung(points, normals, values) {
    return points.map((_, k) => SWING * normals[k] * values[Math.floor(k / 3)]);
  }

  // ---- buffers and programs ------------------------------------------------------------------------------------------
  function buffer(array, target = gl.ARRAY_BUFFER) {
    const id = gl.createBuffer();
    gl.bindBuffer(target, id);
    gl.bufferData(target, array, gl.STATIC_DRAW);
    return id;
  }

  // Segments as ribbons of constant width on the screen: both ends, which end, which side, and how far the ends swing.
  function ribbons(points, pairs, swings) {
    const vertices = [], index = [];
    const of = (list, k) => (list ? [list[3 * k], list[3 * k + 1], list[3 * k + 2]] : [0, 0, 0]);
    for (let s = 0; s < pairs.length; s += 2) {
      const ends = [pairs[s], pairs[s + 1]], first = vertices.length / RIBBON;
      const [p, q] = ends.map((k) => of(points, k)), [d, e] = ends.map((k) => of(swings, k));
      for (const [end, side] of [[0, -1], [0, 1], [1, -1], [1, 1]]) vertices.push(...p, ...q, end, side, ...d, ...e);
      index.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
    }
    return {
      vertices: buffer(new Float32Array(vertices)),
      index: buffer(new Uint16Array(index), gl.ELEMENT_ARRAY_BUFFER),
      count: index.length,
    };
  }

  function program(vertex, fragment) {
    const id = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(id, shader);
    }
    gl.linkProgram(id);
    if (!gl.getProgramParameter(id, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(id));
    const uniform = {}, attribute = {};
    for (let k = 0; k < gl.getProgramParameter(id, gl.ACTIVE_UNIFORMS); k++) {
      const name = gl.getActiveUniform(id, k).name;
      uniform[name] = gl.getUniformLocation(id, name);
    }
    for (let k = 0; k < gl.getProgramParameter(id, gl.ACTIVE_ATTRIBUTES); k++) {
      const name = gl.getActiveAttrib(id, k).name;
      attribute[name] = gl.getAttribLocation(id, name);
    }
    return { id, uniform, attribute };
  }

  const skin = program(
    `attribute vec3 point, normal, swing, lean; attribute float value; uniform mat4 matrix; uniform mat3 turn;
     uniform float phase; varying vec3 n; varying float t;
     void main() {
       n = turn * (normal + phase * lean); t = value; gl_Position = matrix * vec4(point + phase * swing, 1.0);
     }`,
    `precision highp float; varying vec3 n; varying float t;
     uniform sampler2D scale; uniform vec3 none; uniform float low; uniform bool plain; uniform vec3 paint;
     void main() {
       float x = (clamp(t, low, 1.0) - low) / (1.0 - low);
       vec3 c = plain ? paint : t > 1e6 ? none : texture2D(scale, vec2((x * 255.0 + 0.5) / 256.0, 0.5)).rgb;
       vec3 m = normalize(n); if (m.z < 0.0) m = -m;
       float light = 0.66 + 0.30 * max(dot(m, normalize(vec3(-0.35, 0.55, 0.9))), 0.0)
                          + 0.10 * max(dot(m, normalize(vec3(0.8, -0.3, 0.5))), 0.0);
       float shine = 0.10 * pow(max(dot(m, normalize(vec3(-0.18, 0.30, 0.95))), 0.0), 40.0);
       gl_FragColor = vec4(c * light + shine, 1.0);
     }`);
  const ink = program(
    `attribute vec3 from, to, fromSwing, toSwing; attribute vec2 corner;
     uniform mat4 matrix; uniform vec2 size; uniform float width, phase;
     void main() {
       vec4 p = matrix * vec4(from + phase * fromSwing, 1.0), q = matrix * vec4(to + phase * toSwing, 1.0);
       vec2 along = (q.xy / q.w - p.xy / p.w) * size;
       float length = max(sqrt(dot(along, along)), 1e-6);
       vec2 across = vec2(-along.y, along.x) / length * width / size;
       vec4 here = corner.x < 0.5 ? p : q;
       gl_Position = here + vec4(across * corner.y * here.w, -0.0016 * here.w, 0.0);
     }`,
    `precision mediump float; uniform vec4 colour; void main() { gl_FragColor = vec4(colour.rgb * colour.a, colour.a); }`);
  const dots = program(
    `attribute vec3 point; attribute float edge; uniform mat4 matrix; uniform float width; varying float e;
     void main() { e = edge; gl_Position = matrix * vec4(point, 1.0); gl_Position.z -= 0.002 * gl_Position.w;
       gl_PointSize = width; }`,
    `precision mediump float; varying float e; uniform vec4 colour; uniform vec3 inside;
     void main() {
       float r = 2.0 * length(gl_PointCoord - 0.5);
       if (r > 1.0) discard;
       vec3 c = e > 0.5 || r > 0.68 ? colour.rgb : inside;
       gl_FragColor = vec4(c * colour.a, colour.a);
     }`);

  const surfaces = data.surfaces.map((surface) => {
    const points = floats(surface.points), { faces, wires } = grid(surface);
    const outward = normals(points, faces), swings = surface.swings && swung(points, outward, floats(surface.values[data.mode]));
    const lean = swings && normals(points.map((x, k) => x + swings[k]), faces).map((x, k) => x - outward[k]);
    const all = floats(surface.net.points), edges = places(surface.net.edges);
    const near = [...surface.net.boundary.keys()].filter((k) =>
      Math.hypot(all[3 * k], all[3 * k + 1], all[3 * k + 2]) <= REACH);
    const net = Float32Array.from(near.flatMap((k) => [all[3 * k], all[3 * k + 1], all[3 * k + 2]]));
    const lines = clipped(all, edges);
    return {
      ...surface,
      points,
      faces,
      vertices: buffer(points),
      normals: buffer(outward),
      swing: swings && buffer(swings),
      lean: lean && buffer(lean),
      index: buffer(faces, gl.ELEMENT_ARRAY_BUFFER),
      count: faces.length,
      fields: surface.values.map((text) =>
        buffer(floats(text).map((x) => (Number.isNaN(x) ? NONE : Math.max(-1e5, Math.min(1e5, x)))))),
      wires: ribbons(points, wires, swings),
      rim: ribbons(points, segments(surface, "rim"), swings),
      borders: ribbons(points, segments(surface, "border"), swings),
      kinks: ribbons(points, segments(surface, "kink"), swings),
      edges: ribbons(lines.points, lines.pairs),
      netPoints: buffer(net),
      netEdge: buffer(Float32Array.from(near, (k) => surface.net.boundary[k])),
      netCount: net.length / 3,
    };
  });

  const scales = data.scales.map((text) => {
    const colours = bytes(text), id = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, id);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, colours);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    for (const use of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, use, gl.LINEAR);
    return { id, colours };
  });

  // ---- camera: turns about the z axis and about the horizon ------------------------------------------------------------
  // Nets that are large or of many points would hide their surface: they are drawn only when asked for. Of too many points there is none.
  const nets = data.surfaces.map((surface) => surface.net).filter((net) => net.boundary.length);
  $("net").parentElement.hidden = !nets.length;
  $("net").checked = nets.length > 0 && !nets.some((net) => net.large || net.many);
  const state = {
    surface: data.best, other: -1, field: data.field ?? -1, net: $("net").checked, wires: $("wires").checked, phase: 0,
  };
  const DISTANCE = data.fields.length;
  const camera = {};

  function axes() {
    const [ca, sa, ce, se] = [Math.cos(camera.turn), Math.sin(camera.turn), Math.cos(camera.tilt), Math.sin(camera.tilt)];
    return { right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], back: [ce * ca, ce * sa, se] };
  }

  const views = () => (state.other < 0 ? 1 : 2);

  // The first view: all surfaces fill the canvas, whatever their nets reach to. Until it is left, it follows the canvas.
  let first = "";
  function home() {
    Object.assign(camera, data.home);
    const { right, up, back } = axes(), aspect = canvas.clientWidth / views() / canvas.clientHeight || 1;
    const dot = (a, p, k) => a[0] * p[k] + a[1] * p[k + 1] + a[2] * p[k + 2];
    let [low, high] = [[9, 9], [-9, -9]];
    const each = (act) => surfaces.forEach(({ points: p }) => { for (let k = 0; k < p.length; k += 3) act(p, k); });
    each((p, k) => {
      const at = [dot(right, p, k), dot(up, p, k)];
      low = at.map((x, i) => Math.min(x, low[i]));
      high = at.map((x, i) => Math.max(x, high[i]));
    });
    const middle = [0, 1].map((i) => (low[i] + high[i]) / 2);
    camera.pan = middle.map((x) => -x);
    camera.distance = 0.6;
    each((p, k) => {
      const reach = Math.max(Math.abs(dot(right, p, k) - middle[0]) / aspect, Math.abs(dot(up, p, k) - middle[1]));
      camera.distance = Math.max(camera.distance, dot(back, p, k) + 1.05 * reach * FOCAL);
    });
    first = JSON.stringify(camera);
  }

  function matrices() {
    const { right, up, back } = axes(), aspect = canvas.width / views() / canvas.height, [px, py] = camera.pan;
    const d = camera.distance, [near, far] = [Math.max(0.05 * d, d - 12), d + 12];
    const view = [
      right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0, px, py, -d, 1];
    const [fx, fy, z, w] = [FOCAL / aspect, FOCAL, (far + near) / (near - far), (2 * far * near) / (near - far)];
    const matrix = new Float32Array(16);
    for (let c = 0; c < 4; c++) {
      matrix[4 * c] = fx * view[4 * c];
      matrix[4 * c + 1] = fy * view[4 * c + 1];
      matrix[4 * c + 2] = z * view[4 * c + 2] + w * view[4 * c + 3];
      matrix[4 * c + 3] = -view[4 * c + 2];
    }
    return { matrix, turn: new Float32Array([...view.slice(0, 3), ...view.slice(4, 7), ...view.slice(8, 11)]) };
  }

  // ---- drawing -----------------------------------------------------------------------------------------------------------
  function bind(id, location, size, stride = 0, offset = 0) {
    gl.bindBuffer(gl.ARRAY_BUFFER, id);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, stride, offset);
  }

  function lines(ribbon, width, colour, matrix) {
    if (!ribbon.count) return;
    gl.useProgram(ink.id);
    gl.uniformMatrix4fv(ink.uniform.matrix, false, matrix);
    gl.uniform2f(ink.uniform.size, canvas.width / views(), canvas.height);
    gl.uniform1f(ink.uniform.width, width);
    gl.uniform1f(ink.uniform.phase, state.phase);
    gl.uniform4fv(ink.uniform.colour, colour);
    const parts = [["from", 3], ["to", 3], ["corner", 2], ["fromSwing", 3], ["toSwing", 3]];
    parts.reduce((offset, [name, size]) => {
      bind(ribbon.vertices, ink.attribute[name], size, 4 * RIBBON, 4 * offset);
      return offset + size;
    }, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, ribbon.index);
    gl.drawElements(gl.TRIANGLES, ribbon.count, gl.UNSIGNED_SHORT, 0);
  }

  function points(surface, size, colour, inside, matrix) {
    gl.useProgram(dots.id);
    gl.uniformMatrix4fv(dots.uniform.matrix, false, matrix);
    gl.uniform1f(dots.uniform.width, size);
    gl.uniform4fv(dots.uniform.colour, colour);
    gl.uniform3fv(dots.uniform.inside, inside);
    bind(surface.netPoints, dots.attribute.point, 3);
    bind(surface.netEdge, dots.attribute.edge, 1);
    gl.drawArrays(gl.POINTS, 0, surface.netCount);
  }

  function paint() {
    const ratio = Math.min(devicePixelRatio || 1, 2.5);
    const [w, h] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    if (!w || !h) return;
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthFunc(gl.LEQUAL);
    const shown = [state.surface, state.other].slice(0, views());
    shown.forEach((index, k) => {
      gl.viewport(Math.round((k * w) / shown.length), 0, Math.round(w / shown.length), h);
      paintOne(index, shown[1 - k], ratio);
    });
  }

  // The values of the field chosen on a surface; those of the distance are found when first asked for.
  const distances = new Map();
  function values(index, other) {
    if (state.field !== DISTANCE) return surfaces[index].fields[state.field];
    const full = distanceScale(), here = distances.get(`${index} ${other}`);
    return (here.buffer ??= buffer(here.found.map((x) => x / full)));
  }
  function distanceScale() {
    const [a, b] = [state.surface, state.other];
    const found = [[a, b], [b, a]].map((pair) => distances.get(pair.join(" ")) ?? measured(...pair));
    return Math.max(found[0].largest, found[1].largest) || 1;
  }
  function measured(index, other) {
    const found = distancesTo(surfaces[index].points, surfaces[other]);
    const entry = { found, largest: found.reduce((a, b) => Math.max(a, b), 0) };
    distances.set(`${index} ${other}`, entry);
    return entry;
  }

  // How far each point lies from a mesh: the triangles at its nearest vertex are looked at.
  function distancesTo(points, { points: mesh, faces }) {
    const around = Array.from({ length: mesh.length / 3 }, () => []);
    for (let f = 0; f < faces.length; f += 3) for (let k = 0; k < 3; k++) around[faces[f + k]].push(f);
    return Float32Array.from({ length: points.length / 3 }, (_, p) => {
      const at = [points[3 * p], points[3 * p + 1], points[3 * p + 2]];
      let [best, nearest] = [Infinity, 0];
      for (let v = 0; v < mesh.length; v += 3) {
        const [x, y, z] = [mesh[v] - at[0], mesh[v + 1] - at[1], mesh[v + 2] - at[2]], d = x * x + y * y + z * z;
        if (d < best) [best, nearest] = [d, v / 3];
      }
      const corner = (k) => [0, 1, 2].map((i) => mesh[3 * k + i] - at[i]);
      for (const f of around[nearest])
        best = Math.min(best, fromOrigin(corner(faces[f]), corner(faces[f + 1]), corner(faces[f + 2])));
      return Math.sqrt(best);
    });
  }

  // The square of the distance of a triangle from the origin.
  function fromOrigin(a, b, c) {
    const minus = (p, q) => p.map((x, k) => x - q[k]), dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    const edge = (p, q) => {
      const d = minus(q, p), t = Math.max(0, Math.min(1, -dot(p, d) / (dot(d, d) || 1)));
      const r = p.map((x, k) => x + t * d[k]);
      return dot(r, r);
    };
    const [e, g] = [minus(b, a), minus(c, a)], [ee, eg, gg] = [dot(e, e), dot(e, g), dot(g, g)];
    const [ea, ga, det] = [-dot(a, e), -dot(a, g), ee * gg - eg * eg];
    const [s, t] = [(gg * ea - eg * ga) / det, (ee * ga - eg * ea) / det];
    if (det > 0 && s >= 0 && t >= 0 && s + t <= 1) {
      const foot = a.map((x, k) => x + s * e[k] + t * g[k]);
      return dot(foot, foot);
    }
    return Math.min(edge(a, b), edge(b, c), edge(c, a));
  }

  function paintOne(index, other, ratio) {
    const dark = isDark(), surface = surfaces[index], { matrix, turn } = matrices();
    const pen = dark ? [0.88, 0.91, 0.95] : [0.11, 0.15, 0.2];
    gl.useProgram(skin.id);
    gl.uniformMatrix4fv(skin.uniform.matrix, false, matrix);
    gl.uniformMatrix3fv(skin.uniform.turn, false, turn);
    gl.uniform1i(skin.uniform.plain, state.field < 0 ? 1 : 0);
    gl.uniform3f(skin.uniform.paint, 0.80, 0.84, 0.88);
    gl.uniform3fv(skin.uniform.none, data.none.map((c) => c / 255));
    if (state.field >= 0) {
      const signed = fields(state.field).signed, buffered = values(index, other);
      gl.bindTexture(gl.TEXTURE_2D, scales[signed ? 0 : 1].id);
      gl.uniform1f(skin.uniform.low, signed ? -1 : 0);
      bind(buffered, skin.attribute.value, 1);
    } else {
      gl.disableVertexAttribArray(skin.attribute.value);
      gl.vertexAttrib1f(skin.attribute.value, 0);
    }
    gl.uniform1f(skin.uniform.phase, state.phase);
    for (const name of ["swing", "lean"]) {
      if (surface[name]) bind(surface[name], skin.attribute[name], 3);
      else {
        gl.disableVertexAttribArray(skin.attribute[name]);
        gl.vertexAttrib3f(skin.attribute[name], 0, 0, 0);
      }
    }
    bind(surface.vertices, skin.attribute.point, 3);
    bind(surface.normals, skin.attribute.normal, 3);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, surface.index);
    gl.drawElements(gl.TRIANGLES, surface.count, gl.UNSIGNED_SHORT, 0);

    // Lines on the coloured surface are dark in either theme.
    if (state.wires) lines(surface.wires, 0.9 * ratio, [0.08, 0.12, 0.18, 0.34], matrix);
    lines(surface.borders, 0.9 * ratio, [0.08, 0.12, 0.18, 0.6], matrix);
    lines(surface.kinks, 2 * ratio, dark ? [1, 0.54, 0.5, 1] : [0.7, 0.15, 0.12, 1], matrix);
    lines(surface.rim, 1.5 * ratio, dark ? [0.8, 0.84, 0.9, 0.9] : [...pen, 0.85], matrix);
    // Control points do not swing with their surface.
    if (state.net && surface.netCount && !(surface.swing && state.phase)) {
      const crowded = surface.netCount > 100;
      const [width, size] = crowded ? [0.8, 4] : [1.4, 9];
      const inside = dark ? [0.11, 0.13, 0.16] : [1, 1, 1];
      // What the surface hides stays faintly visible.
      gl.disable(gl.DEPTH_TEST);
      lines(surface.edges, width * ratio, [...pen, 0.2], matrix);
      gl.enable(gl.DEPTH_TEST);
      lines(surface.edges, width * ratio, [...pen, 0.8], matrix);
      gl.disable(gl.DEPTH_TEST);
      points(surface, size * ratio, [...pen, 1], inside, matrix);
      gl.enable(gl.DEPTH_TEST);
    }
  }

  let waiting = false;
  draw = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      paint();
    });
  };

  // ---- choices ---------------------------------------------------------------------------------------------------------------
  const written = (x) => {
    if (x === 0) return "0";
    const text = Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5 ? x.toExponential(2) : String(+x.toPrecision(3));
    return text.replace(/-/g, "−");
  };

  // A field of the data, or the distance to the other surface.
  function fields(k) {
    if (k < DISTANCE) return data.fields[k];
    const full = distanceScale() * data.radius;
    return { name: "distance to the other surface", symbol: "", unit: "length", signed: false, full, largest: full };
  }

  function legend() {
    const field = state.field < 0 ? null : fields(state.field);
    $("legend").hidden = !field;
    if (!field) return;
    const { colours } = scales[field.signed ? 0 : 1];
    const stops = Array.from({ length: 33 }, (_, k) => {
      const at = 3 * Math.min(255, k * 8);
      return `rgb(${colours[at]},${colours[at + 1]},${colours[at + 2]}) ${(k * 100) / 32}%`;
    });
    $("bar").style.background = `linear-gradient(to right, ${stops.join(",")})`;
    const more = field.largest > field.full * 1.000001;
    const [low, high] = [field.signed ? -field.full : 0, field.full];
    $("low").textContent = (more && field.signed ? "≤ " : "") + written(low);
    $("middle").textContent = field.signed ? "0" : written(high / 2);
    $("high").textContent = (more ? "≥ " : "") + written(high);
    const size = field.signed ? `|${field.symbol}|` : field.symbol;
    const clipped = `; clipped at ${field.signed ? "±" : ""}${written(field.full)}, largest ${size} ${written(field.largest)}`;
    $("quantity").textContent =
      `${field.name} ${field.symbol}`.trim() + (field.unit ? ` in ${field.unit}` : "") + (more ? clipped : "");
  }

  function choose(index) {
    state.surface = index;
    told();
  }

  function told() {
    const [surface, other] = [surfaces[state.surface], surfaces[state.other]];
    const said = ({ name, caption }) => `${name}: ${caption}`;
    $("caption").textContent = other ? `Left: ${said(surface)}. Right: ${said(other)}` : said(surface);
    canvas.setAttribute("aria-label", `${surface.name}. ${$("help").textContent}`);
    $("swing").hidden = !surface.swing && !other?.swing;
    if ($("swing").hidden) still();
    legend();
    draw();
  }

  const methods = $("methods");
  if (data.deformation || surfaces.length > 16) {
    methods.insertAdjacentHTML("beforeend",
      '<div class="frames"><button type="button" id="play" aria-pressed="false">Play</button>' +
      '<input type="range" id="frame" min="0" value="0" aria-label="Surface"></div>');
    const slider = $("frame");
    slider.max = surfaces.length - 1;
    slider.value = state.surface;
    const set = (k) => {
      slider.value = k;
      slider.setAttribute("aria-valuetext", surfaces[k].name);
      choose(k);
    };
    slider.addEventListener("input", () => set(+slider.value));
    let timer = 0;
    $("play").addEventListener("click", () => {
      const playing = !timer;
      if (timer) clearInterval(timer);
      timer = playing ? setInterval(() => set((+slider.value + 1) % surfaces.length), 350) : 0;
      $("play").textContent = playing ? "Pause" : "Play";
      $("play").setAttribute("aria-pressed", String(playing));
    });
  } else {
    choices(methods, "method", surfaces.map((surface, k) => [surface.name, k]), state.surface, choose);
  }
  if (surfaces.length > 1) {
    const compare = $("compare");
    compare.closest("label").hidden = false;
    surfaces.forEach((surface, k) => compare.append(new Option(surface.name, k)));
    compare.addEventListener("change", () => {
      state.other = +compare.value;
      // The distance has a meaning beside another surface only.
      colourings();
      home();
      told();
    });
  }

  function chip(group, value, text, checked, act) {
    const label = document.createElement("label"), input = document.createElement("input");
    Object.assign(input, { type: "radio", name: group, value, checked });
    input.addEventListener("change", act);
    const span = document.createElement("span");
    span.textContent = text;
    label.className = "chip";
    label.append(input, span);
    return label;
  }

  // One of several: chips where there is room, a list on phones or if there are many.
  function choices(place, group, entries, chosen, act) {
    const list = document.createElement("select"), legend = place.querySelector("legend");
    list.setAttribute("aria-label", legend.textContent);
    place.replaceChildren(legend);
    const pick = (value) => {
      list.value = value;
      place.querySelectorAll("input").forEach((input) => (input.checked = +input.value === value));
      act(value);
    };
    for (const [text, value] of entries) {
      place.append(chip(group, value, text, value === chosen, () => pick(value)));
      list.append(new Option(text, value, false, value === chosen));
    }
    place.classList.toggle("many", entries.length > 6);
    list.addEventListener("change", () => pick(+list.value));
    place.append(list);
  }

  function colourings() {
    const entries = data.fields.map((field, k) => [field.label, k]);
    if (state.other >= 0) entries.push(["distance", DISTANCE]);
    else if (state.field === DISTANCE) state.field = data.field ?? -1;
    choices($("fields"), "field", [...entries, ["plain", -1]], state.field, (k) => {
      state.field = k;
      legend();
      draw();
    });
  }
  colourings();
  for (const name of ["net", "wires"])
    $(name).addEventListener("change", () => {
      state[name] = $(name).checked;
      draw();
    });

  // ---- the swing of a mode ----------------------------------------------------------------------------------------------------
  const PERIOD = 2400; // milliseconds
  let swinging = 0;
  function still() {
    cancelAnimationFrame(swinging);
    swinging = 0;
    state.phase = 0;
    $("swing").setAttribute("aria-pressed", "false");
    draw();
  }
  function swing() {
    const begun = performance.now();
    const on = (now) => {
      state.phase = Math.sin((2 * Math.PI * Math.max(0, now - begun)) / PERIOD);
      draw();
      swinging = requestAnimationFrame(on);
    };
    $("swing").setAttribute("aria-pressed", "true");
    // Where motion is not wanted, the surface stands at one end of its swing.
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      state.phase = 1;
      draw();
    } else swinging = requestAnimationFrame(on);
  }
  const swingOrNot = () => ($("swing").hidden ? 0 : $("swing").getAttribute("aria-pressed") === "true" ? still() : swing());
  $("swing").addEventListener("click", swingOrNot);

  // ---- pointer, wheel, keyboard -----------------------------------------------------------------------------------------------
  const reset = () => {
    home();
    draw();
  };
  const rotate = (x, y) => {
    camera.turn -= x;
    camera.tilt = Math.max(-1.57, Math.min(1.57, camera.tilt + y));
    draw();
  };
  const zoom = (factor) => {
    camera.distance = Math.max(0.6, Math.min(60, camera.distance * factor));
    draw();
  };
  const pan = (x, y) => {
    const step = (camera.distance * 0.52) / canvas.clientHeight;
    camera.pan = [camera.pan[0] + x * step, camera.pan[1] - y * step];
    draw();
  };
  // A swipe up or down scrolls the page, as everywhere; one that begins with a moment's rest, or of two fingers, turns.
  const fingers = new Map(), REST = 220, SLIP = 8;
  let [held, resting] = [false, 0];
  const hold = () => {
    held = true;
    canvas.classList.add("held");
  };
  const release = () => {
    clearTimeout(resting);
    held = false;
    canvas.classList.remove("held");
  };
  const spread = () => {
    const [p, q] = [...fingers.values()];
    return Math.hypot(p[0] - q[0], p[1] - q[1]);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (event.pointerType !== "touch" || fingers.size > 1) hold();
    else resting = setTimeout(hold, REST);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = fingers.get(event.pointerId);
    if (!last) return;
    const [x, y] = [event.clientX - last[0], event.clientY - last[1]];
    if (!held && Math.hypot(x, y) < SLIP) return;
    clearTimeout(resting);
    const before = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size === 2) {
      zoom(before / Math.max(spread(), 1));
      pan(x / 2, y / 2);
    } else if (event.shiftKey || event.buttons & 6) pan(x, y);
    else rotate(x * 0.008, held ? y * 0.008 : 0);
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => {
      fingers.delete(event.pointerId);
      if (!fingers.size) release();
    });
  canvas.addEventListener("touchmove", (event) => {
    if (held || event.touches.length > 1) event.preventDefault();
  }, { passive: false });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("wheel", (event) => {
    // The page scrolls past the canvas unless someone works in it.
    if (!event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(event.deltaY * (event.ctrlKey ? 0.01 : 0.0012)));
  }, { passive: false });
  const keys = {
    ArrowLeft: () => rotate(-0.1, 0), ArrowRight: () => rotate(0.1, 0),
    ArrowUp: () => rotate(0, -0.1), ArrowDown: () => rotate(0, 0.1),
    "+": () => zoom(0.9), "=": () => zoom(0.9), "-": () => zoom(1 / 0.9), "0": reset, Home: reset,
    m: swingOrNot,
  };
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  $("reset").addEventListener("click", reset);
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => location.reload());
  new ResizeObserver(() => {
    if (JSON.stringify(camera) === first) home();
    draw();
  }).observe(canvas);

  if (matchMedia("(pointer: coarse)").matches)
    $("help").textContent = "Swipe sideways to turn; rest a finger, then move it, to turn freely; two fingers zoom and move.";
  home();
  told();
})();
