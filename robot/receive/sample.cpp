// SPDX-License-Identifier: MIT
#include "robot/receive/sample.h"

#include <algorithm>

#include "robot/rtde/fields.h"

namespace tiller::receive {

SampleLayout::SampleLayout(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const rtde::Field* field = rtde::findOutput(name);
        const bool known = std::any_of(entries_.begin(), entries_.end(),
                                       [&](const Entry& entry) { return entry.name == name; });
        if (field == nullptr || known) {
            continue;
        }
        entries_.push_back({name, field->type, size_, field->components()});
        size_ += field->components();
    }
    for (const Entry& entry : entries_) {
        for (std::size_t i = 0; i < entry.count; ++i) {
            componentNames_.push_back(rtde::componentName(entry.name, entry.type, i));
        }
    }
    // The vectors are not reallocated after this point.
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        entryByName_.emplace(entries_[i].name, i);
    }
    for (std::size_t i = 0; i < componentNames_.size(); ++i) {
        componentByName_.emplace(componentNames_[i], i);
    }
}

const SampleLayout::Entry* SampleLayout::find(std::string_view name) const {
    const auto found = entryByName_.find(name);
    return found == entryByName_.end() ? nullptr : &entries_[found->second];
}

std::optional<std::size_t> SampleLayout::indexOfComponent(std::string_view component) const {
    const auto found = componentByName_.find(component);
    return found == componentByName_.end() ? std::nullopt : std::optional(found->second);
}

QStringList unknownOutputs(const std::vector<std::string>& names) {
    QStringList sentences;
    for (const std::string& name : names) {
        if (rtde::findOutput(name) != nullptr) {
            continue;
        }
        const std::string_view nearest = rtde::nearestOutput(name);
        const QString there =
            QStringLiteral("there is no RTDE output \"%1\"").arg(QString::fromStdString(name));
        sentences << (nearest.empty() ? there
                                      : QStringLiteral("%1: did you mean \"%2\"?").arg(there, Text(nearest)));
    }
    return sentences;
}

std::span<const double> Sample::field(std::string_view name) const {
    const SampleLayout::Entry* entry = layout ? layout->find(name) : nullptr;
    if (entry == nullptr || entry->first + entry->count > values.size() || std::isnan(values[entry->first])) {
        return {};
    }
    return std::span(values).subspan(entry->first, entry->count);
}

}  // namespace tiller::receive
