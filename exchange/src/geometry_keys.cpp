#include "geometry_keys.hpp"

namespace settle::exchange {
namespace {

KeyTable<Polygon> polygon_keys() {
  KeyTable<Polygon> keys("A part of a layer, with the shape \"polygons\" only. Parts that touch share whole edges.");
  keys.integer("layer", &Polygon::layer, {.range = at_least(1), .doc = "the layer it belongs to"});
  keys.real_lists("corners", &Polygon::corners,
                  {.unit = "m",
                   .count = {.least = 3},
                   .required = true,
                   .doc = "`[x, y]` of the corners of a convex polygon, anticlockwise"},
                  {.least = 2, .most = 2});
  keys.text("material", &Polygon::material,
            {.doc = "the NAME of a `[material.NAME]`, the same for all of a layer; left out: `construction.material`"});
  return keys;
}

KeyTable<Embankment> embankment_keys() {
  KeyTable<Embankment> keys("A section with a level crest, with the shape \"embankment\" only. x = 0 in the middle of "
                            "the crest, y = 0 at the "
                            "base of the fill; layers are level and of equal thickness.");
  keys.real("height", &Embankment::height,
            {.unit = "m", .range = above(0), .required = true, .doc = "of the fill, from its base to the crest"});
  keys.real("crest", &Embankment::crest,
            {.unit = "m", .range = above(0), .required = true, .doc = "width of the crest"});
  keys.reals("slopes", &Embankment::slopes,
             {.range = at_least(0),
              .count = {.least = 2, .most = 2},
              .required = true,
              .doc = "left and right, horizontal per vertical; 0: a vertical side"});
  keys.real("foundation_depth", &Embankment::foundation_depth,
            {.unit = "m",
             .range = at_least(0),
             .doc = "0: a rough rigid base; above: layer 1 is existing ground of this depth on such a base"});
  keys.real("foundation_left", &Embankment::foundation_left,
            {.unit = "m", .range = at_least(0), .doc = "extent of the ground beyond the left toe"});
  keys.real("foundation_right", &Embankment::foundation_right,
            {.unit = "m", .range = at_least(0), .doc = "extent of the ground beyond the right toe"});
  keys.text("foundation_material", &Embankment::foundation_material,
            {.doc = "the NAME of a `[material.NAME]`; left out: `construction.material`"});
  return keys;
}

KeyTable<Valley> valley_keys() {
  KeyTable<Valley> keys("A valley that an embankment closes as a dam, in 3-D only, instead of `depth`: rough and rigid "
                        "floor and flanks, the same all along x. y = 0 in the middle of the floor.");
  keys.real("bottom", &Valley::bottom,
            {.unit = "m", .range = at_least(0), .required = true, .doc = "width of the floor; 0: a V"});
  keys.reals("slopes", &Valley::slopes,
             {.range = at_least(0),
              .count = {.least = 2, .most = 2},
              .required = true,
              .doc = "of the flanks towards -y and y, horizontal per vertical; 0: a vertical flank"});
  return keys;
}

KeyTable<Mesh> mesh_keys() {
  KeyTable<Mesh> keys("A mesh by Gmsh (ASCII, version 2.2 or 4.1), with the shape \"mesh\" only: quadrilaterals in the "
                      "plane of x and y, y the height, or hexahedra, z the height. Its physical groups are layers and "
                      "parts of the boundary.");
  keys.text("file", &Mesh::file, {.required = true, .doc = "MSH file, relative to the folder of the case file"});
  keys.text("text", &Mesh::text, {.doc = "what is in the file; a case that is written holds it, and needs no file"});
  keys.texts("ground", &Mesh::ground,
             {.doc = "groups that are there before anything is built, from below: layers 1, 2, ..."});
  keys.texts("layers", &Mesh::layers,
             {.count = {.least = 1},
              .required = true,
              .doc = "groups in the order of construction: the layers after the ground. Every cell is in one group of "
                     "these two lists"});
  keys.toml_values("materials", &Mesh::materials,
                   {.doc = "`group = \"NAME\"` of a `[material.NAME]`; of a group left out: `construction.material`"});
  keys.texts("fixed", &Mesh::fixed, {.doc = "groups of the boundary that are held in all directions"});
  keys.texts("roller", &Mesh::roller,
             {.doc = "groups of the boundary, each part at right angles to an axis, that are held along it. What is "
                     "in neither list is free"});
  return keys;
}

} // namespace

KeyTable<Geometry> geometry_keys() {
  KeyTable<Geometry> keys("The domain that is built up. Required.");
  keys.choice("shape", &Geometry::shape, {.required = true, .doc = "what is built"});
  keys.real("height", &Geometry::height,
            {.unit = "m",
             .range = above(0),
             .left_out = "required for a column; the extent of what is drawn",
             .doc = "design height of all layers together"});
  keys.real("width", &Geometry::width,
            {.unit = "m",
             .range = above(0),
             .left_out = "required for a column; the extent of what is drawn",
             .doc = "extent along x"});
  keys.real("depth", &Geometry::depth,
            {.unit = "m",
             .range = above(0),
             .left_out = "the width; in a valley that of the crest; that of a mesh of hexahedra",
             .doc = "extent along y, in 3-D only; a drawn section is extruded along it"});
  keys.integer(
      "dimension", &Geometry::dimension,
      {.range = from_to(2, 3), .required = true, .doc = "2: plane strain, gravity along -y; 3: gravity along -z"});
  keys.table_array("polygon", &Geometry::polygons, polygon_keys());
  keys.table("embankment", &Geometry::embankment, embankment_keys());
  keys.table("valley", &Geometry::valley, valley_keys());
  keys.table("mesh", &Geometry::mesh, mesh_keys());
  return keys;
}

} // namespace settle::exchange
