// SPDX-License-Identifier: MIT
#pragma once

// The robots of one program, in the order in which they were added. The name of a station is its key. A
// signal of a station has the key "name/field", e.g. "Lab UR5e/actual_q_0".

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "robot/core/result.h"
#include "robot/station/station.h"

namespace tiller {

/// Threads  GUI
class StationList : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    int count() const { return static_cast<int>(stations_.size()); }
    Station& at(int index) const { return *stations_[static_cast<std::size_t>(index)]; }
    /// Returns null if there is no station with this name.
    Station* find(const QString& name) const;
    /// Returns the station of a signal key "name/field"; null if there is none.
    Station* ofSignal(const QString& key) const;

    /// Adds a station at the end.
    /// Errors  InvalidArgument if the name is empty, contains "/" or already exists
    Result<Station*> add(std::unique_ptr<Station> station);
    /// Ends the connection and removes the station.
    /// Returns  false if there is no station with this name
    bool remove(const QString& name);

Q_SIGNALS:
    void added(tiller::Station& station);
    /// The station still exists and is connected, but is no longer in the list.
    void removed(tiller::Station& station);

private:
    std::vector<std::unique_ptr<Station>> stations_;
};

}  // namespace tiller
