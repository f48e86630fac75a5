// SPDX-License-Identifier: MIT
#pragma once

// A list of requested fields with the types that the controller reported. A field unknown to the robot is
// listed as absent; this is not an error.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/rtde/codec.h"
#include "robot/rtde/values.h"

namespace tiller::rtde {

/// One field of an active recipe.
struct RecipeField {
    std::string name;
    DataType type = DataType::Double;
    std::size_t first = 0;  ///< index of its first number in the values of the recipe
};

class Recipe {
public:
    Recipe() = default;
    /// requested, answers  must have equal length; fields answered without a type become absent
    Recipe(std::uint8_t id, const std::vector<std::string>& requested,
           const std::vector<FieldAnswer>& answers);

    std::uint8_t id() const { return id_; }  ///< Recipe id assigned by the controller.
    /// True if packages of this recipe can be sent or received.
    bool isValid() const { return id_ != 0; }
    const std::vector<RecipeField>& fields() const { return fields_; }
    /// Requested fields that the robot does not have.
    const std::vector<std::string>& absent() const { return absent_; }
    const ValueLayout& layout() const { return layout_; }
    /// Number of values in one package.
    std::size_t size() const { return layout_.components(); }

    /// Returns null if the recipe does not contain the field.
    const RecipeField* find(std::string_view name) const;
    /// Index of the field's first number in the values; empty if the robot does not have the field.
    std::optional<std::size_t> indexOf(std::string_view name) const;
    bool has(std::string_view name) const { return find(name) != nullptr; }

private:
    std::uint8_t id_ = 0;
    std::vector<RecipeField> fields_;
    std::vector<std::string> absent_;
    ValueLayout layout_;

    friend class Session;
};

}  // namespace tiller::rtde
