// SPDX-License-Identifier: MIT
#pragma once

// What was asked of the controller and what it answered: one list of fields with the types the robot itself
// reported. A field it does not know is absent, which is a fact about the robot and not a failure.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/rtde/codec.h"
#include "robot/rtde/values.h"

namespace tiller::rtde {

/// One field of a recipe in force.
struct RecipeField {
    std::string name;
    DataType type = DataType::Double;
    std::size_t first = 0;  ///< index of its first number among the recipe's values
};

class Recipe {
public:
    Recipe() = default;
    /// requested, answers  of equal length; fields not answered with a type are absent
    Recipe(std::uint8_t id, const std::vector<std::string>& requested,
           const std::vector<FieldAnswer>& answers);

    std::uint8_t id() const { return id_; }  ///< As the controller gave it.
    /// True when packages of this recipe can be sent or will come.
    bool isValid() const { return id_ != 0; }
    const std::vector<RecipeField>& fields() const { return fields_; }  ///< In the order of the package.
    const std::vector<std::string>& absent() const { return absent_; }  ///< Asked for, but not there.
    const ValueLayout& layout() const { return layout_; }               ///< Of the package.
    /// Numbers in one set of values.
    std::size_t size() const { return layout_.components(); }

    const RecipeField* find(std::string_view name) const;  ///< Null when it is not among them.
    /// Index of the field's first number among the values; nothing when the robot does not have it.
    std::optional<std::size_t> indexOf(std::string_view name) const;
    bool has(std::string_view name) const { return find(name) != nullptr; }  ///< It is among the fields.

private:
    std::uint8_t id_ = 0;
    std::vector<RecipeField> fields_;
    std::vector<std::string> absent_;
    ValueLayout layout_;

    friend class Session;
};

}  // namespace tiller::rtde
