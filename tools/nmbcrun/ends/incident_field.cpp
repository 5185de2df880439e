// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/incident_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace nmbcrun {
namespace {

using Fields = nmbc::NodeLine<double>;
using ConstFields = nmbc::NodeLine<const double>;

class IncidentFieldCondition final : public nmbc::BoundaryCondition<double> {
  public:
    IncidentFieldCondition(std::unique_ptr<nmbc::BoundaryCondition<double>> inner, nmbc::End end,
                           std::shared_ptr<const IncidentField> incident,
                           const nmbc::Lattice& lattice, const nmbc::ChainParameters& p)
        : inner_(std::move(inner)),
          end_(end),
          incident_(std::move(incident)),
          time_step_(p.time_step) {
        const std::size_t outside = lattice.reach() + inner_->layer_nodes();
        const std::size_t nodes = outside + inner_->least_interior_nodes();
        const double first =
            end == nmbc::End::left ? 1 - double(outside) : double(p.nodes + outside + 1 - nodes);
        at_rest_.reserve(nodes);
        waves_.emplace(incident_->waves, first - incident_->origin, p.time_step);
        for (std::size_t node = 0; node < nodes; ++node) {
            at_rest_.push_back(incident_->per_node * (first + double(node) - incident_->middle));
        }
        for (auto* field : {&u_incident_, &v_incident_}) {
            field->resize(nodes);
        }
        for (auto* field : {&u_, &v_}) {
            field->resize(outside + p.nodes);
        }
    }

    std::size_t layer_nodes() const override { return inner_->layer_nodes(); }
    std::size_t least_interior_nodes() const override { return inner_->least_interior_nodes(); }

    void start(Fields u, Fields v, std::size_t step) override {
        find_incident(double(step) - 1);
        const std::vector<double> v_incident = v_incident_;
        find_incident(double(step));
        v_incident_ = v_incident;
        // What is further inside is for the inner end to compare with what is near: an exact one
        // takes for rest what is a rounding of the whole.
        for (std::size_t node = at_rest_.size(); node < u_.size(); ++node) {
            Fields({u_}, end_)[node] = u[node];
            Fields({v_}, end_)[node] = v[node];
        }
        take_off(u, v);
        drop_roundings();
        inner_->start({u_, end_}, {v_, end_}, step);
        add_again(u, {u_, end_}, {u_incident_, end_});
        add_again(v, {v_, end_}, {v_incident_, end_});
    }

    void after_kick(ConstFields u, Fields v, std::size_t step) override {
        find_incident(double(step));
        take_off(u, v);
        inner_->after_kick({std::span<const double>(u_), end_}, {v_, end_}, step);
        add_again(v, {v_, end_}, {v_incident_, end_});
    }

    std::span<const double> memory() const override { return inner_->memory(); }
    void remember(std::span<const double> memory) override { inner_->remember(memory); }

  private:
    /// u_b at a step, v_b half a step on.
    void find_incident(double step) {
        u_incident_ = at_rest_;
        std::ranges::fill(v_incident_, 0.0);
        if (step < incident_->last_wave) {
            waves_->add(step - incident_->arrival, u_incident_, v_incident_);
        }
    }

    void take_off(ConstFields u, ConstFields v) {
        const Fields u_left({u_}, end_);
        const Fields v_left({v_}, end_);
        const Fields u_incident({u_incident_}, end_);
        const Fields v_incident({v_incident_}, end_);
        for (std::size_t node = 0; node < at_rest_.size(); ++node) {
            u_left[node] = u[node] - u_incident[node];
            v_left[node] = v[node] - v_incident[node];
        }
    }

    /// Of the incident field, which is a sum: where it is all there is, nothing is left of it.
    void drop_roundings() {
        double size = 0;
        for (const LatticeWave& wave : incident_->waves) {
            size += std::abs(wave.amplitude);
        }
        for (const double u : at_rest_) {
            size = std::max(size, std::abs(u));
        }
        constexpr double roundings = 1e-13;
        for (std::size_t node = 0; node < at_rest_.size(); ++node) {
            double& u = Fields({u_}, end_)[node];
            double& v = Fields({v_}, end_)[node];
            u = std::abs(u) > roundings * size ? u : 0;
            v = std::abs(v) > roundings * size / time_step_ ? v : 0;
        }
    }

    /// What the inner end has left alone stays as it is, to the last bit.
    void add_again(Fields field, Fields changed, Fields incident) const {
        for (std::size_t node = 0; node < at_rest_.size(); ++node) {
            if (changed[node] != field[node] - incident[node]) {
                field[node] = changed[node] + incident[node];
            }
        }
    }

    std::unique_ptr<nmbc::BoundaryCondition<double>> inner_;
    nmbc::End end_;
    std::shared_ptr<const IncidentField> incident_;
    double time_step_;
    std::optional<WavesAtNodes> waves_;
    // Of the nodes that the inner end may read or write, from left to right.
    std::vector<double> at_rest_;
    std::vector<double> u_incident_;
    std::vector<double> v_incident_;
    std::vector<double> u_;
    std::vector<double> v_;
};

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> IncidentFieldEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> /*precision*/) const {
    return std::make_unique<IncidentFieldCondition>(inner.make(lattice, parameters), end, incident,
                                                    lattice, parameters);
}

}  // namespace nmbcrun
