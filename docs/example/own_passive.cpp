// SPDX-License-Identifier: MIT
/// A code over a plane lattice of your own with passive sides: the loop, the arrays and the forces
/// are yours; the library only gives numbers. nmbc::Plane does the same, to compare.
///
/// Here: a square of stabilised NOPD in plane stress, a pulse, E = density = dX = 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nmbc/plane_stability.hpp>
#include <vector>

#include "passive_side.hpp"

using Field = std::array<std::vector<double>, 2>;  // components along x and y

const nmbc::PassiveSide& passive = nmbc::generated::passive_nopd2d_r1_nu3o10_g1o4;
const nmbc::CorrespondenceModel lattice = nmbc::nopd2d(1, 0.3, 0.25 * 3.14159265358979323846);

constexpr int interior = 40;
const int layers = static_cast<int>(passive.strain.size());
const int horizon = static_cast<int>(lattice.horizon());
const int n = interior + 2 * (layers + horizon);  // the nodes further out have the lattice's forces

struct Node {
    double V = 0;                     // times its energy of strain
    double w = 0;                     // s, times its energy of stabilisation
    std::array<double, 2> mass{};     // of the equation of a component
    std::array<double, 3> inverse{};  // xx, xy, yy of the shape tensor of the neighbours left
};

bool is_there(int x, int y) {
    return x >= 0 && x < n && y >= 0 && y < n;
}
std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y * n + x);
}

/// Calls work(J, R) for the neighbours of (x, y) that are there.
template <class Work>
void for_neighbours(int x, int y, const Work& work) {
    for (int j = -horizon; j <= horizon; ++j) {
        for (int i = -horizon; i <= horizon; ++i) {
            const int square = i * i + j * j;
            if (square > 0 && square <= static_cast<int>(lattice.radius_squared) &&
                is_there(x + i, y + j)) {
                work(at(x + i, y + j), std::array<double, 2>{double(i), double(j)});
            }
        }
    }
}

/// Of a node, by its place along one axis between two sides: what the side's list has of its layer.
double along(const std::vector<double>& of_layers, int place) {
    const int layer = std::min(place, n - 1 - place);
    return layer < layers ? of_layers[static_cast<std::size_t>(layer)] : 1;
}

/// Where sides meet, their numbers are multiplied.
std::vector<Node> make_nodes() {
    std::vector<Node> nodes(static_cast<std::size_t>(n * n));
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            Node& node = nodes[at(x, y)];
            node.V = along(passive.strain, x) * along(passive.strain, y);
            node.w = lattice.stabilisation * along(passive.stabilisation, x) *
                     along(passive.stabilisation, y);
            // The first mass is of the component across the side, the second of that along it.
            node.mass = {along(passive.mass[0], x) * along(passive.mass[1], y),
                         along(passive.mass[1], x) * along(passive.mass[0], y)};
            double xx = 0;
            double xy = 0;
            double yy = 0;
            for_neighbours(x, y, [&](std::size_t, const std::array<double, 2>& R) {
                xx += R[0] * R[0];
                xy += R[0] * R[1];
                yy += R[1] * R[1];
            });
            const double determinant = xx * yy - xy * xy;
            node.inverse = {yy / determinant, -xy / determinant, xx / determinant};
        }
    }
    return nodes;
}

/// v += dt M^-1 times the forces. Theirs is the energy, sum over the nodes of
///     V (W + beta (u_x,x u_y,y - u_x,y u_y,x)) + Vs Ws.
void kick(const std::vector<Node>& nodes, double dt, const Field& u, Field& v) {
    std::vector<std::array<double, 4>> T(nodes.size());  // xx, xy, yx, yy
    const double k = lattice.bulk;
    const double mu = lattice.shear;
    const double beta = passive.null_lagrangian;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const Node& own = nodes[at(x, y)];
            const auto& [xx, xy, yy] = own.inverse;
            std::array<double, 4> g{};  // the gradient
            for (std::size_t a = 0; a < 2; ++a) {
                for_neighbours(x, y, [&](std::size_t J, const std::array<double, 2>& R) {
                    const double difference = u[a][J] - u[a][at(x, y)];
                    g[2 * a] += difference * (xx * R[0] + xy * R[1]);
                    g[2 * a + 1] += difference * (xy * R[0] + yy * R[1]);
                });
            }
            const std::array<double, 4> P{own.V * ((k + mu) * g[0] + (k - mu + beta) * g[3]),
                                          own.V * (mu * g[1] + (mu - beta) * g[2]),
                                          own.V * (mu * g[2] + (mu - beta) * g[1]),
                                          own.V * ((k + mu) * g[3] + (k - mu + beta) * g[0])};
            for (std::size_t a = 0; a < 2; ++a) {
                T[at(x, y)][2 * a] = P[2 * a] * xx + P[2 * a + 1] * xy - own.w * g[2 * a];
                T[at(x, y)][2 * a + 1] = P[2 * a] * xy + P[2 * a + 1] * yy - own.w * g[2 * a + 1];
            }
        }
    }
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const std::size_t I = at(x, y);
            for (std::size_t a = 0; a < 2; ++a) {
                double force = 0;
                for_neighbours(x, y, [&](std::size_t J, const std::array<double, 2>& R) {
                    force += (T[I][2 * a] + T[J][2 * a]) * R[0] +
                             (T[I][2 * a + 1] + T[J][2 * a + 1]) * R[1] +
                             (nodes[I].w + nodes[J].w) * (u[a][J] - u[a][I]);
                });
                v[a][I] += dt * force / nodes[I].mass[a];
            }
        }
    }
}

/// Between nodes at these places along an axis across which sides are; part 0: of the component
/// across the side, 1: along it.
double dashpot(std::size_t part, int i, int j) {
    if (std::max(i, j) >= layers && std::min(i, j) < n - layers) {
        return 0;
    }
    const int row = std::min(i, n - 1 - i);
    const int column = std::min(j, n - 1 - j);
    return passive.dashpots[part][static_cast<std::size_t>(row * layers + column)];
}

/// Nodes that dashpots join.
struct Group {
    std::size_t component = 0;
    std::vector<std::size_t> nodes{};
    std::vector<double> drag{};    // dt S C, S = (M + dt C/2)^-1
    std::vector<double> before{};  // v before the step
};

/// The solution X of A X = B, both size times size, row by row; A is positive definite.
std::vector<double> solve(std::vector<double> A, std::vector<double> B, std::size_t size) {
    for (std::size_t pivot = 0; pivot < size; ++pivot) {
        for (std::size_t row = 0; row < size; ++row) {
            const double factor = A[row * size + pivot] / A[pivot * size + pivot];
            for (std::size_t i = 0; i < size && row != pivot; ++i) {
                A[row * size + i] -= factor * A[pivot * size + i];
                B[row * size + i] -= factor * B[pivot * size + i];
            }
        }
    }
    for (std::size_t i = 0; i < size * size; ++i) {
        B[i] /= A[i / size * (size + 1)];
    }
    return B;
}

/// In corners the dashpots of each side act times the V of the other.
Group make_group(const std::vector<Node>& nodes, double dt, std::size_t a,
                 const std::vector<int>& columns, const std::vector<int>& rows) {
    Group group{a};
    std::vector<double> sum;  // M + dt C/2
    for (const int y : rows) {
        for (const int x : columns) {
            group.nodes.push_back(at(x, y));
            for (const int other_y : rows) {
                for (const int other_x : columns) {
                    double C = 0;
                    if (y == other_y) {
                        C += dashpot(a, x, other_x) * along(passive.strain, y);
                    }
                    if (x == other_x) {
                        C += dashpot(1 - a, y, other_y) * along(passive.strain, x);
                    }
                    group.drag.push_back(dt * C);
                    const bool is_own = x == other_x && y == other_y;
                    sum.push_back(dt * C / 2 + (is_own ? nodes[at(x, y)].mass[a] : 0));
                }
            }
        }
    }
    group.drag = solve(std::move(sum), std::move(group.drag), group.nodes.size());
    group.before.resize(group.nodes.size());
    return group;
}

/// Along an axis the layers of a side go together, and each of the other nodes alone.
std::vector<Group> make_groups(const std::vector<Node>& nodes, double dt) {
    std::vector<std::vector<int>> places(2);
    for (int layer = 0; layer < layers; ++layer) {
        places[0].push_back(layer);
        places[1].push_back(n - 1 - layer);
    }
    for (int place = layers; place < n - layers; ++place) {
        places.push_back({place});
    }
    std::vector<Group> groups;
    for (const auto& columns : places) {
        for (const auto& rows : places) {
            for (std::size_t a = 0; a < 2 && columns.size() * rows.size() > 1; ++a) {
                groups.push_back(make_group(nodes, dt, a, columns, rows));
            }
        }
    }
    return groups;
}

void keep(std::vector<Group>& groups, const Field& v) {
    for (Group& group : groups) {
        for (std::size_t i = 0; i < group.nodes.size(); ++i) {
            group.before[i] = v[group.component][group.nodes[i]];
        }
    }
}

/// v+ = v* - dt S C (v- + v*)/2, v* what the forces have made of v-.
void close(const std::vector<Group>& groups, Field& v) {
    for (const Group& group : groups) {
        const std::size_t size = group.nodes.size();
        std::vector<double> mean(size);
        for (std::size_t i = 0; i < size; ++i) {
            mean[i] = (group.before[i] + v[group.component][group.nodes[i]]) / 2;
        }
        for (std::size_t i = 0; i < size * size; ++i) {
            v[group.component][group.nodes[i / size]] -= group.drag[i] * mean[i % size];
        }
    }
}

int main() {
    const auto sides = nmbc::PlaneSides::all(passive);
    nmbc::PlaneParameters body{.nx = interior, .ny = interior};
    body.time_step =
        0.9 * 2 / std::sqrt(nmbc::highest_eigenvalue(lattice, sides, body.nx, body.ny));
    nmbc::Plane plane(lattice, sides, body);

    const std::vector<Node> nodes = make_nodes();
    std::vector<Group> groups = make_groups(nodes, body.time_step);
    Field u;  // displacement at t
    Field v;  // velocity at t - dt/2
    u.fill(std::vector<double>(nodes.size(), 0));
    v = u;
    const int first = layers + horizon;
    for (int y = 0; y < interior; ++y) {
        for (int x = 0; x < interior; ++x) {
            const double pulse = std::exp(-(std::pow(x - 22, 2) + std::pow(y - 17, 2)) / 25);
            u[1][at(first + x, first + y)] = pulse;
            plane.displacement(
                1)[plane.entry(static_cast<std::size_t>(x), static_cast<std::size_t>(y))] = pulse;
        }
    }
    plane.start_staggered();
    const double at_first = plane.interior_energies().total();

    constexpr int steps = 200;
    for (int step = 0; step < steps; ++step) {
        keep(groups, v);
        kick(nodes, body.time_step, u, v);
        close(groups, v);
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                u[a][i] += body.time_step * v[a][i];
            }
        }
    }
    plane.advance(steps);

    double difference = 0;
    for (int y = 0; y < interior; ++y) {
        for (int x = 0; x < interior; ++x) {
            const std::size_t entry =
                plane.entry(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
            for (std::size_t a = 0; a < 2; ++a) {
                difference = std::max(difference, std::abs(plane.displacement(a)[entry] -
                                                           u[a][at(first + x, first + y)]));
            }
        }
    }
    std::printf("after %d steps %.1e of the energy is left; nmbc::Plane differs by %.0e\n", steps,
                plane.interior_energies().total() / at_first, difference);
    return difference < 1e-12 ? 0 : 1;  // some roundings a step, of displacements up to 1
}
