# SPDX-License-Identifier: MIT
"""The names in requests that rasterizer.py knows. An unknown name may change what must be drawn, so
the scene is refused. Unknown keys beside the scene never change what is drawn, so they are
ignored."""

KEYS = {
    "scene": "target viewport depth_range details textures draws",
    "target": "width height samples sample_positions color depth surface clear stencil clear_depth "
              "clear_stencil supersampling",
    "draw": "primitive interpolation provoking_vertex line_width point_size scissor multisampling "
            "texture front_face cull polygon_offset stencil depth blend color_mask vertices",
    "vertex": "position w clip color texture_coordinates",
}
NAMES = {
    "color": "rgba8", "interpolation": "flat smooth noperspective", "provoking_vertex": "first last",
    "primitive": "points lines line_strip line_loop triangles triangle_strip triangle_fan",
}


def unknown_in(kind, thing):
    """The unknown keys of a part of the scene, and the unknown names in it."""
    keys = [key for key in thing if key not in KEYS[kind].split()]
    return keys + [value for key, value in thing.items()
                   if isinstance(value, str) and key in NAMES and value not in NAMES[key].split()]


def refusal(request):
    """The answer to a request with something unknown; none for any other."""
    if request["edgecase"] != 1:
        return {"not_run": "this example speaks version 1"}
    scene = request["scene"]
    unknown = unknown_in("scene", scene) + unknown_in("target", scene["target"])
    for draw in scene["draws"]:
        unknown += unknown_in("draw", draw)
        for vertex in draw["vertices"]:
            unknown += unknown_in("vertex", vertex)
    return {"not_run": f"this example does not know {unknown[0]!r}"} if unknown else None
