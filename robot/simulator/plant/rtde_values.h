// SPDX-License-Identifier: MIT
#pragma once

// Sources of the values of all RTDE output fields. All values are simulated. Fields of equipment that does
// not exist (Euromap) have the values of unconnected equipment.

#include <optional>
#include <string_view>
#include <vector>

#include "robot/rtde/codec.h"
#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"
#include "robot/simulator/plant/telemetry.h"

namespace tiller::simulator {

/// Source of one RTDE output field.
struct FieldSource {
    using Read = void (*)(const Telemetry& now, std::size_t number, double* into);
    Read read = nullptr;
    std::size_t number = 0;  ///< register number
    std::size_t components = 1;
};

/// Source of a catalogue entry; empty if it does not exist. A test checks that every output field has a
/// source.
std::optional<FieldSource> fieldSource(const rtde::Field& field);

/// The fields of one output recipe.
class OutputRecipe {
public:
    /// answers() lists for each name whether this software has the field.
    OutputRecipe(const std::vector<std::string>& names, const SoftwareVersion& software,
                 bool isListed = false);

    /// One answer per name, in the same order.
    const std::vector<rtde::FieldAnswer>& answers() const { return answers_; }
    /// True if there is at least one name and all were found.
    bool isValid() const { return valid_; }
    /// Writes a complete data package. recipeId is used as in rtde::writeDataPackage.
    rtde::ByteView write(const Telemetry& now, std::optional<std::uint8_t> recipeId);

private:
    std::vector<rtde::FieldAnswer> answers_;
    std::vector<FieldSource> sources_;
    rtde::ValueLayout layout_;
    std::vector<double> values_;
    rtde::Bytes package_;
    bool valid_ = false;
};

}  // namespace tiller::simulator
