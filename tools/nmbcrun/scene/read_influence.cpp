// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/read_influence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/families/influence.hpp"

namespace nmbcrun {
namespace {

constexpr const char* influence_key = "model.influence";

std::vector<nmbcgen::Rational> named(SceneReader& reader, unsigned horizon) {
    const std::string name = reader.text(influence_key).value();
    const auto list = nmbcgen::influences();
    const auto found = std::ranges::find(list, name, &nmbcgen::Influence::name);
    if (found == list.end()) {
        std::string names;
        for (const nmbcgen::Influence& influence : list) {
            names += fmt::format("\"{}\", ", influence.name);
        }
        reader.fail(influence_key,
                    fmt::format("must be {}or a list of {} exact numbers, not \"{}\"", names,
                                horizon, name));
    }
    return weights_of(*found, horizon);
}

bool may_be_negative(std::string_view family) {
    const auto known = nmbcgen::families();
    const auto found = std::ranges::find(known, family, &nmbcgen::Family::name);
    return found != known.end() && found->has_signed_weights;
}

std::vector<nmbcgen::Rational> listed(SceneReader& reader, std::string_view family,
                                      unsigned horizon) {
    std::vector<nmbcgen::Rational> weights;
    for (const std::string& text : reader.numbers_or_texts(influence_key)) {
        try {
            weights.push_back(nmbcgen::parse_signed_rational(text));
        } catch (const std::invalid_argument& error) {
            reader.fail(influence_key,
                        fmt::format("must be a list of exact numbers: {}", error.what()));
        }
        if (weights.back() == 0) {
            reader.fail(influence_key, "has a 0: every bond needs a weight other than 0");
        }
        if (weights.back() < 0 && !may_be_negative(family)) {
            reader.fail(influence_key,
                        fmt::format("has a weight below 0, which {} does not take", family));
        }
    }
    if (weights.size() != horizon) {
        reader.fail(influence_key, fmt::format("has {} weights, where horizon {} needs {}",
                                               weights.size(), horizon, horizon));
    }
    return weights;
}

}  // namespace

std::vector<std::string> read_influence(SceneReader& reader, std::string_view family, int horizon) {
    if (!reader.has(influence_key)) {
        return {};
    }
    const auto weights = nmbcgen::normalised(reader.is_text(influence_key)
                                                 ? named(reader, unsigned(horizon))
                                                 : listed(reader, family, unsigned(horizon)));
    std::vector<std::string> texts;
    texts.reserve(weights.size());
    for (const nmbcgen::Rational& weight : weights) {
        texts.push_back(nmbcgen::to_string(weight));
    }
    return texts;
}

}  // namespace nmbcrun
