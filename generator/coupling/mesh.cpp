// SPDX-License-Identifier: MIT
#include "generator/coupling/mesh.hpp"

namespace nmbcgen {

Mesh mesh_of(const Halves& halves, std::size_t left_elements, std::size_t right_elements) {
    Mesh mesh;
    for (std::size_t i = left_elements; i > 0; --i) {
        mesh.nodes.push_back(-Rational(i) * halves.left_length);
        mesh.media.push_back(halves.left);
    }
    mesh.nodes.emplace_back(0);
    for (std::size_t i = 1; i <= right_elements; ++i) {
        mesh.nodes.push_back(Rational(i) * halves.right_length);
        mesh.media.push_back(halves.right);
    }
    return mesh;
}

}  // namespace nmbcgen
