#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

/// A wedge in each file format that pages support, and invalid files.
namespace wedge {

using corner = std::array<float, 3>;

inline constexpr corner corners[]{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
inline constexpr std::array<int, 3> triangles[]{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

inline std::string three(const corner& c) {
  return std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]);
}

/// Normals are zero, as in the output of many programs.
inline std::string binary_stl() {
  std::string all(80, ' ');
  const auto append = [&all](auto value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    all.append(bytes, sizeof value);
  };
  append(std::uint32_t{4});
  for (const auto& t : triangles) {
    for (int i = 0; i < 3; ++i) append(0.0f);
    for (int i : t)
      for (float x : corners[i]) append(x);
    append(std::uint16_t{0});
  }
  return all;
}

inline std::string ascii_stl() {
  std::string all = "solid wedge\n";
  for (const auto& t : triangles) {
    all += "facet normal 0 0 0\n outer loop\n";
    for (int i : t) all += "  vertex " + three(corners[i]) + "\n";
    all += " endloop\nendfacet\n";
  }
  return all + "endsolid wedge\n";
}

inline std::string obj() {
  std::string all = "mtllib wedge.mtl\no wedge\n";
  for (const corner& c : corners) all += "v " + three(c) + "\n";
  all += "usemtl skin\n";
  for (const auto& t : triangles) {
    all += "f";
    for (int i : t) all += " " + std::to_string(i + 1);
    all += "\n";
  }
  return all + "l 1 2\n"; // remains of a program
}

/// In centimeters, z up, with a lamp; a node moves the wedge by one meter to its place.
inline std::string dae(const std::string& diffuse) {
  std::string places, indices;
  for (const corner& c : corners) places += three({100 * c[0] - 100, 100 * c[1], 100 * c[2]}) + " ";
  for (const auto& t : triangles)
    for (int i : t) indices += std::to_string(i) + " ";
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="skin"><init_from>skin.png</init_from></image></library_images>
<library_effects><effect id="effect"><profile_COMMON>
<newparam sid="surface"><surface type="2D"><init_from>skin</init_from></surface></newparam>
<newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>
<technique sid="common"><lambert><diffuse>)" +
         diffuse + R"(</diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="material"><instance_effect url="#effect"/></material></library_materials>
<library_lights><light id="lamp"><technique_common><point><color>1 0 0</color></point></technique_common></light>
</library_lights>
<library_geometries><geometry id="wedge"><mesh>
<source id="places"><float_array id="numbers" count="12">)" +
         places + R"(</float_array><technique_common><accessor source="#numbers" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="vertices"><input semantic="POSITION" source="#places"/></vertices>
<triangles material="skin" count="4"><input semantic="VERTEX" source="#vertices" offset="0"/><p>)" +
         indices + R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene">
<node id="body"><translate>100 0 0</translate><instance_geometry url="#wedge"><bind_material><technique_common>
<instance_material symbol="skin" target="#material"/></technique_common></bind_material></instance_geometry></node>
<node id="light"><translate>9000 0 0</translate><instance_light url="#lamp"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
}

/// Entities that would expand to three billion letters.
inline std::string entities() {
  std::string all = "<?xml version=\"1.0\"?><!DOCTYPE COLLADA [<!ENTITY e0 \"ha\">";
  for (int i = 1; i < 10; ++i) {
    const std::string one = "&e" + std::to_string(i - 1) + ";";
    all += "<!ENTITY e" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) all += one;
    all += "\">";
  }
  return all + "]><COLLADA><asset>&e9;</asset></COLLADA>";
}

inline void write(const std::string& directory) {
  const auto leave = [&directory](const std::string& name, const std::string& text) {
    std::ofstream(directory + "/" + name, std::ios::binary) << text;
  };
  leave("binary.STL", binary_stl());
  leave("text.stl", ascii_stl());
  leave("wedge.obj", obj());
  leave("wedge.dae", dae("<texture texture=\"sampler\" texcoord=\"uv\"/>"));
  leave("green.dae", dae("<color>0 0.8 0 1</color>"));
  leave("cut.stl", binary_stl().substr(0, 120));
  leave("vast.stl", std::string(80, ' ') + "\xFF\xFF\xFF\xFF");
  leave("words.stl", "solid words");
  leave("entities.dae", entities());
  leave("robot.dae", "<robot/>");
  leave("cut.dae", dae("").substr(0, 1500));
  leave("points.obj", "v 0 0 0\nv 1 0 0\n");
  leave("odd.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

inline constexpr const char* broken[]{"cut.stl",   "vast.stl", "words.stl",  "entities.dae",
                                      "robot.dae", "cut.dae",  "points.obj", "odd.obj"};

} // namespace wedge
