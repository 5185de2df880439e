// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/csv.hpp"

#include <fmt/format.h>

#include <optional>

#include "generator/exact/algebraic_number.hpp"

namespace stability_atlas {
namespace {

std::string method_columns(const nmbcgen::Specification& method) {
    return fmt::format("{},{},{}", method.horizon, method.order, method.stride);
}

std::string or_empty(const std::optional<double>& value) {
    return value ? fmt::format("{:.9g}", *value) : "";
}

std::string_view name_of(nmbcgen::Grade grade) {
    switch (grade) {
        case nmbcgen::Grade::none:
            return "none";
        case nmbcgen::Grade::paired:
            return "paired";
        case nmbcgen::Grade::contractive:
            return "contractive";
    }
    return "";
}

std::string window_row(const nmbcgen::Specification& method, std::string_view kind, double low,
                       const std::optional<double>& high) {
    return fmt::format("{},{},{:.9g},{}\n", method_columns(method), kind, low, or_empty(high));
}

std::string window_rows(const nmbcgen::Specification& method, std::string_view kind,
                        const std::vector<nmbcgen::StabilityWindow>& windows) {
    std::string rows;
    for (const nmbcgen::StabilityWindow& window : windows) {
        rows += window_row(method, kind, window.low.inner,
                           window.high ? std::optional(window.high->inner) : std::nullopt);
    }
    return rows;
}

}  // namespace

std::string points_csv(const std::vector<Method>& methods) {
    std::string csv =
        "horizon,order,stride,G,supremum,growing_mode_rate,failure,grade,in_modal_window,"
        "in_scalar_window,measured_growth\n";
    for (const Method& method : methods) {
        for (const Point& point : method.points) {
            csv += fmt::format("{},{:.9g},{},{:.9g},{},{},{:d},{:d},{}\n",
                               method_columns(method.specification), point.G,
                               or_empty(point.supremum), point.growing_mode_rate,
                               name_of(point.failure), name_of(point.grade), point.in_modal_window,
                               point.in_scalar_window, or_empty(point.measured_growth));
        }
    }
    return csv;
}

std::string windows_csv(const std::vector<Method>& methods) {
    std::string csv = "horizon,order,stride,kind,low,high\n";
    for (const Method& method : methods) {
        for (const nmbcgen::ExactWindow& window : method.scalar) {
            csv += window_row(
                method.specification, "scalar", nearest_double(window.low),
                window.high ? std::optional(nearest_double(*window.high)) : std::nullopt);
        }
        csv += window_rows(method.specification, "modal", method.windows.modal);
        csv += window_rows(method.specification, "contractive", method.windows.contractive);
    }
    return csv;
}

}  // namespace stability_atlas
