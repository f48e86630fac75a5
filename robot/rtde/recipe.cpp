// SPDX-License-Identifier: MIT
#include "robot/rtde/recipe.h"

#include <algorithm>

namespace tiller::rtde {

Recipe::Recipe(std::uint8_t id, const std::vector<std::string>& requested,
               const std::vector<FieldAnswer>& answers)
    : id_(id) {
    std::vector<DataType> types;
    std::size_t first = 0;
    for (std::size_t i = 0; i < std::min(requested.size(), answers.size()); ++i) {
        if (answers[i].kind != FieldAnswer::Kind::Type) {
            absent_.push_back(requested[i]);
            continue;
        }
        fields_.push_back({requested[i], answers[i].type, first});
        types.push_back(answers[i].type);
        first += componentCount(answers[i].type);
    }
    layout_ = ValueLayout(std::move(types));
}

const RecipeField* Recipe::find(std::string_view name) const {
    const auto found =
        std::find_if(fields_.begin(), fields_.end(), [&](const RecipeField& f) { return f.name == name; });
    return found == fields_.end() ? nullptr : &*found;
}

std::optional<std::size_t> Recipe::indexOf(std::string_view name) const {
    const RecipeField* field = find(name);
    return field == nullptr ? std::nullopt : std::optional(field->first);
}

}  // namespace tiller::rtde
