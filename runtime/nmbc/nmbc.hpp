// SPDX-License-Identifier: MIT
/// Everything of the runtime; the tables are in <nmbc/tables/...>.
#pragma once

#include <nmbc/boundary.hpp>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/certificate.hpp>
#include <nmbc/chain.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/edge_closure.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>
#include <nmbc/higdon.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/node_line.hpp>
#include <nmbc/passive.hpp>
#include <nmbc/plane.hpp>
#include <nmbc/plane_convex_kernel.hpp>
#include <nmbc/plane_pml.hpp>
#include <nmbc/plane_stability.hpp>
#include <nmbc/surface.hpp>
#include <nmbc/table.hpp>
