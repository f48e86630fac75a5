// SPDX-License-Identifier: MIT
#include "robot/station/station_list.h"

#include <algorithm>
#include <utility>

namespace tiller {

namespace {

constexpr QLatin1Char kSignalSeparator('/');

}  // namespace

Station* StationList::find(const QString& name) const {
    const auto it = std::find_if(stations_.begin(), stations_.end(),
                                 [&name](const auto& station) { return station->name() == name; });
    return it == stations_.end() ? nullptr : it->get();
}

Station* StationList::ofSignal(const QString& key) const {
    const qsizetype separator = key.indexOf(kSignalSeparator);
    return separator < 0 ? nullptr : find(key.left(separator));
}

Result<Station*> StationList::add(std::unique_ptr<Station> station) {
    const QString& name = station->name();
    if (name.isEmpty() || name.contains(kSignalSeparator)) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("add the robot \"%1\"").arg(name),
                     QStringLiteral("the name must not be empty and must not contain \"/\"")};
    }
    if (find(name) != nullptr) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("add the robot \"%1\"").arg(name),
                     QStringLiteral("another robot has this name")};
    }
    stations_.push_back(std::move(station));
    Station* result = stations_.back().get();
    Q_EMIT added(*result);
    return result;
}

bool StationList::remove(const QString& name) {
    const auto it = std::find_if(stations_.begin(), stations_.end(),
                                 [&name](const auto& station) { return station->name() == name; });
    if (it == stations_.end()) {
        return false;
    }
    const std::unique_ptr<Station> station = std::move(*it);
    stations_.erase(it);
    Q_EMIT removed(*station);
    return true;
}

}  // namespace tiller

#include "moc_station_list.cpp"
