// SPDX-License-Identifier: GPL-2.0-or-later
/// stability_atlas orders: its options.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/stability_atlas/orders.hpp"

namespace stability_atlas {

/// Adds the subcommand, which fills in the question.
CLI::App* add_orders(CLI::App& app, OrdersQuestion& question);

}  // namespace stability_atlas
