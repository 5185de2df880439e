// SPDX-License-Identifier: GPL-2.0-or-later
/// Ends that let a field in: a preload stays at rest, an incoming wave is a wave of the lattice, and
/// what comes back leaves.
#include <doctest/doctest.h>

#include "tests/nmbcrun/bar.hpp"
#include <cstdio>

namespace nmbcrun::test {
namespace {

TEST_CASE("probe") {
    for (const auto kind : {BoundaryKind::nmbc, BoundaryKind::fixed, BoundaryKind::free}) {
        Scene scene = bar(50, 1e9);
        scene.preload = Preload{0.01};
        scene.left.kind = scene.right.kind = kind;
        Simulation s(scene);
        for (int i = 0; i < 100000; ++i) s.step();
        std::printf("preload kind %d: err %.3g v %.3g  largest u %.3g\n", int(kind),
            largest_error(s, [&](double X) { return 0.01 * (X - 25.5 * 0.5); }),
            largest(s.chain().velocity()), largest(s.chain().displacement()));
    }
    for (double wn : {0.0, 0.5, 1.0, 1.5, 2.2}) for (double width : {10., 20.}) {
        Scene scene = bar(100, 1);
        scene.incoming = Incoming{nmbc::End::left, {wn == 0 ? Shape::gaussian : Shape::packet, 0.01, width * 0.5, wn}, 40};
        scene.end = 40;
        Simulation s(scene);
        run_to_end(s);
        std::printf("wn %g width %g: steps %zu, at arrival left %.4g ", wn, width, s.plan().steps, s.chain().displacement()[s.chain().first_interior()]);
        Scene big = bar(4000, 40);
        big.initial = Initial{};
        // reference: extended bar with an initial one-way wave
        scene.end = 65;
        Simulation t(scene);
        double most = 0; double e0=0;
        while (!t.is_done()) { t.step(); most = std::max(most, t.energies().total()); if (!t.is_driven(t.chain().time()) && e0==0) {e0 = t.energies().total(); std::printf("drive over at %g ", t.chain().time());} }
        std::printf("peak %.4g left %.3g\n", most, t.energies().total()/most);
    }
}

}  // namespace
}  // namespace nmbcrun::test
