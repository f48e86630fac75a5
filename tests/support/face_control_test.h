// SPDX-License-Identifier: MIT
#pragma once

// What the tests of ur_rtde's control interface share: for each test function a simulated robot, and an
// interface that controls it.

#include <ur_rtde/rtde_control_interface.h>

#include <QObject>
#include <memory>

#include "tests/integration/ur_rtde/face_cell.h"

namespace tiller::test {

class FaceControlTest : public QObject {
    Q_OBJECT

protected:
    std::unique_ptr<FaceCell> cell_;
    std::unique_ptr<ur_rtde::RTDEControlInterface> control_;

private Q_SLOTS:
    void init() {
        cell_ = std::make_unique<FaceCell>();
        control_ = std::make_unique<ur_rtde::RTDEControlInterface>(cell_->host());
    }
    void cleanup() {
        control_.reset();
        cell_.reset();
    }
};

}  // namespace tiller::test
