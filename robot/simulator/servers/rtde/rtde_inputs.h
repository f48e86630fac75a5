// SPDX-License-Identifier: MIT
#pragma once

// The inputs written by RTDE clients: their owners, their values, and their effects on the robot. A value is kept
// until its owner changes it; a mask selects the values that a package applies. Source: RTDE guide.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/core/version.h"
#include "robot/rtde/codec.h"
#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"

namespace tiller::simulator {

class Plant;

/// One input recipe of one client.
struct InputRecipe {
    std::vector<std::size_t> fields;  ///< indices into rtde::inputFields()
    rtde::ValueLayout layout;
};

/// Threads  the simulator's.
class RtdeInputs {
public:
    using ClientId = std::uint64_t;

    RtdeInputs(Plant& plant, const SoftwareVersion& software);

    struct Claim {
        std::vector<rtde::FieldAnswer> answers;
        std::optional<InputRecipe> recipe;  ///< nothing when a name is unknown or owned by another client
    };
    /// Takes ownership of all names, or of none. protocol: the client's, on which some types depend
    Claim claim(ClientId client, const std::vector<std::string>& names, rtde::ProtocolVersion protocol);
    /// Frees the inputs of the client; whether the values are kept is an assumption.
    void release(ClientId client);

    /// Applies one data package. False, and nothing changed, when its length is not the recipe's.
    bool apply(const InputRecipe& recipe, rtde::ByteView values);

    /// Runs once per control period before reading: applies the rest of packages of the previous period that were
    /// applied only in part.
    void applyRest();

    /// Packages applied so far.
    std::uint64_t packages() const { return packages_; }

private:
    /// The part of a package that a later period applies.
    struct Rest {
        std::uint64_t period;
        InputRecipe recipe;
        std::vector<double> values;
        std::vector<bool> late;  ///< by field of the recipe
    };

    std::vector<bool> lateFields(std::size_t count) const;
    void storeFields(const InputRecipe& recipe, const std::vector<double>& values,
                     const std::vector<bool>& skipped);
    void store(const rtde::Field& field, const double* value);
    void applyMasks(const InputRecipe& recipe);

    Plant& plant_;
    SoftwareVersion software_;
    std::vector<ClientId> owners_;  ///< by field; 0: none
    std::vector<double> values_;    ///< scratch of apply()
    std::vector<Rest> rests_;
    std::uint64_t packages_ = 0;

    // Values of the fields that act on the robot, as last written.
    double sliderMask_ = 0, sliderFraction_ = 1;
    struct DigitalGroup {
        unsigned mask = 0, value = 0;
    } standard_, configurable_, tool_;
    unsigned analogMask_ = 0, analogType_ = 0;
    double analog_[2] = {0, 0};
};

}  // namespace tiller::simulator
