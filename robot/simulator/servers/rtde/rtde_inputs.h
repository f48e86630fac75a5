// SPDX-License-Identifier: MIT
#pragma once

// Inputs written by RTDE clients: owners, values, and effects on the robot. An input keeps its value until
// its owner changes it. A mask selects the values that a package applies. Source: RTDE guide.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/core/version.h"
#include "robot/rtde/codec.h"
#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"

namespace tiller::simulator {

class ControllerModel;

/// An input recipe of a client.
struct InputRecipe {
    std::vector<std::size_t> fields;  ///< indices into rtde::inputFields()
    rtde::ValueLayout layout;
};

/// Threads  the simulator thread
class RtdeInputs {
public:
    using ClientId = std::uint64_t;

    RtdeInputs(ControllerModel& plant, const SoftwareVersion& software);

    struct Claim {
        std::vector<rtde::FieldAnswer> answers;
        std::optional<InputRecipe> recipe;  ///< empty if a name is unknown or owned by another client
    };
    /// Takes ownership of all names, or fails without any change.
    /// protocol  version used by the client, which determines some types
    Claim claim(ClientId client, const std::vector<std::string>& names, rtde::ProtocolVersion protocol);
    /// Releases the inputs of the client. A behaviour option determines whether they keep their values.
    void release(ClientId client);

    /// Applies one data package. Returns false without any change if the length does not match the recipe.
    bool apply(const InputRecipe& recipe, rtde::ByteView values);

    /// Must be called once per control period, before reading. Applies the rest of packages that were
    /// partially applied in the previous period.
    void applyRest();

    std::uint64_t packages() const { return packages_; }

private:
    /// The part of a package that is applied in a later period.
    struct Rest {
        std::uint64_t period;
        InputRecipe recipe;
        std::vector<double> values;
        std::vector<bool> late;  ///< for each field of the recipe: true if it is applied later
    };

    std::vector<bool> lateFields(std::size_t count) const;
    void storeFields(const InputRecipe& recipe, const std::vector<double>& values,
                     const std::vector<bool>& skipped);
    void store(const rtde::Field& field, const double* value);
    void applyMasks(const InputRecipe& recipe);

    ControllerModel& plant_;
    SoftwareVersion software_;
    std::vector<ClientId> owners_;  ///< client ID for each field; 0: none
    std::vector<double> values_;    ///< buffer for apply()
    std::vector<Rest> rests_;
    std::uint64_t packages_ = 0;

    // Last written values of the fields that affect the robot.
    double sliderMask_ = 0, sliderFraction_ = 1;
    struct DigitalGroup {
        unsigned mask = 0, value = 0;
    } standard_, configurable_, tool_;
    unsigned analogMask_ = 0, analogType_ = 0;
    double analog_[2] = {0, 0};
};

}  // namespace tiller::simulator
