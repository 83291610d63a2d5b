// SPDX-License-Identifier: MIT
// Answers as lines, and who answers.

// JSON has no word for -0 that JavaScript would write.
const NEGATIVE_ZERO = "\u0001-0";
// Lists of whole numbers, which need no look at each of them.
const WHOLE = ["pixels", "hits", "stencils"];

// Numbers that are not finite are words in a line.
function numberWord(value) {
  if (Number.isNaN(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

function toJson(value) {
  const text = JSON.stringify(value, (_, part) => {
    if (typeof part !== "number") return part;
    if (Object.is(part, -0)) return NEGATIVE_ZERO;
    return Number.isFinite(part) ? part : numberWord(part);
  });
  return text.replaceAll(JSON.stringify(NEGATIVE_ZERO), "-0");
}

/** The line of an answer. @param {Record<string, any>} answer */
function lineOf(answer) {
  const members = Object.keys(answer).filter((key) => answer[key] !== undefined).map((key) =>
    `"${key}":${WHOLE.includes(key) ? JSON.stringify(answer[key]) : toJson(answer[key])}`);
  return `{${members.join(",")}}`;
}

const BROWSERS = [["Edg", "Edge"], ["OPR", "Opera"], ["SamsungBrowser", "Samsung Internet"],
  ["HeadlessChrome", "Chromium"], ["Chrome", "Chromium"], ["Firefox", "Firefox"],
  ["FxiOS", "Firefox for iOS"], ["CriOS", "Chrome for iOS"], ["Version", "Safari"]];

/** The browser's name and version, as its user agent gives them. */
function browserOf(agent) {
  for (const [token, name] of BROWSERS) {
    const found = agent.match(new RegExp(`\\b${token}/([\\d.]+)`));
    if (found) return `${name} ${found[1]}`;
  }
  return "unknown browser";
}

// Of "ANGLE (Mesa, llvmpipe (LLVM 15.0.6, 256 bits), OpenGL ES 3.2)" the last part.
function angleBackend(device) {
  if (!device.startsWith("ANGLE (")) return "";
  const parts = device.slice("ANGLE (".length, -1).split(", ");
  return parts[parts.length - 1];
}

/**
 * @typedef {{vendor: string, version: string, device: string, subpixel_bits: number,
 *   traits: Record<string, string>}} Claims
 * @param {SceneRenderer} renderer
 * @returns {Claims}
 */
function claimsOf({gl, limits}) {
  const debug = limits.has.WEBGL_debug_renderer_info;
  const ask = (unmasked, plain) =>
    String(gl.getParameter(debug ? debug[unmasked] : plain) || gl.getParameter(plain));
  const device = ask("UNMASKED_RENDERER_WEBGL", gl.RENDERER);
  const browser = browserOf(navigator.userAgent);
  const backend = angleBackend(device);
  return {
    vendor: ask("UNMASKED_VENDOR_WEBGL", gl.VENDOR),
    version: `OpenGL ES 3.0 (WebGL 2.0) ${browser}`,
    device,
    subpixel_bits: gl.getParameter(gl.SUBPIXEL_BITS),
    traits: {
      api: "OpenGL ES",
      browser,
      ...(backend ? {angle: backend} : {}),
      stack: `${browser}${backend ? `, ANGLE on ${backend}` : ""}, ${device}`,
      glsl: String(gl.getParameter(gl.SHADING_LANGUAGE_VERSION)),
      extensions: Object.keys(limits.has).filter((name) => limits.has[name]).join(" "),
      samples: limits.sampleCounts.join(" ") || "none",
      line_widths: rangeText(limits.lineWidths),
      point_sizes: rangeText(limits.pointSizes),
      max_anisotropy: String(limits.anisotropy),
      provoking_vertices: Object.keys(limits.provokes).filter((which) => limits.provokes[which])
        .join(" ") || "none",
    },
  };
}

/** The answer to a request, without its digest.
 * @param {SceneRenderer} renderer @param {SceneRequest} request @returns {Answer} */
function answerTo(renderer, request) {
  if (request.edgecase !== PROTOCOL_VERSION)
    return {not_run: `version ${request.edgecase} of the protocol is not spoken here`};
  const unknown = unknownIn(request.scene, KNOWN_SCENE);
  return unknown ? {not_run: `/scene${unknown}`} : renderer.outcomeOf(request.scene);
}
