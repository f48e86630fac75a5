// SPDX-License-Identifier: MIT
#include "robot/station/route/path_watch.h"

#include <QElapsedTimer>
#include <algorithm>
#include <utility>

#include "robot/station/document/project_document.h"

namespace tiller {
namespace {

constexpr int kPathLookMs = 40;
constexpr int kAtOnceMs = 4;             ///< time limit per frame
constexpr double kSamePosition = 0.002;  ///< minimum change of any joint [rad]

}  // namespace

PathWatch::PathWatch(const ProjectDocument& document, Permits permits, QObject* parent)
    : QObject(parent), document_(document), permits_(std::move(permits)) {
    timer_.setSingleShot(true);
    timer_.setInterval(kPathLookMs);
    connect(&timer_, &QTimer::timeout, this, &PathWatch::look);
    connect(&document, &ProjectDocument::documentChanged, this, &PathWatch::lookAgain);
}

void PathWatch::setState(const SessionState& state) {
    // Without data, the arm position is unknown, so nothing can be checked.
    const auto check = state.hasData() ? state.check : nullptr;
    if (check != lookedWith_ || (state.q.values - lookedFrom_.values).cwiseAbs().maxCoeff() > kSamePosition) {
        lookedWith_ = check;
        lookedFrom_ = state.q;
        isOutdated_ = true;
    }
    // While the arm moves, the results would be outdated at once.
    if (isOutdated_ && !state.moving) {
        isOutdated_ = false;
        lookAgain();
    }
}

void PathWatch::lookAgain() {
    left_ = document_.waypoints().size();
    if (!timer_.isActive()) {
        timer_.start();
    }
}

void PathWatch::look() {
    QElapsedTimer passed;
    passed.start();
    const int rows = document_.waypoints().size();
    for (left_ = std::min(left_, rows); left_ > 0 && passed.elapsed() < kAtOnceMs; --left_) {
        const int row = next_++ % rows;
        QString limit;
        if (lookedWith_ != nullptr && document_.reach(row).ok()) {
            const Result<void> permitted = permits_(row);
            limit = permitted ? QString() : permitted.error().context;
        }
        Q_EMIT looked(document_.waypoints().at(row).id, limit);
    }
    if (left_ > 0) {
        timer_.start();
    }
}

}  // namespace tiller

#include "moc_path_watch.cpp"
