// SPDX-License-Identifier: MIT
#pragma once

// One examination under way. Private to robot/doctor.

#include <QCoreApplication>
#include <map>
#include <optional>

#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/doctor/examination.h"

namespace tiller::doctor {

/// The texts of the doctor for the translators: lupdate finds them by this name.
struct DoctorText {
    Q_DECLARE_TR_FUNCTIONS(Doctor)
};

class Examiner {
public:
    Examiner(const Patient& patient, const Deadline& deadline,
             const std::function<void(const Finding&)>& each)
        : patient_(patient), deadline_(deadline), each_(each) {}

    Report run();

private:
    // examine_network.cpp
    bool examineAddress();
    void examinePorts();
    // examine_service.cpp
    void examineService();
    void examineDashboard();
    void examineRobotApi();
    void examineModel();
    // examine_data.cpp
    void examineRegisters();
    void examineData();
    void judgeSoftware(const SoftwareVersion& version);
    void judgeModes(RobotMode mode, SafetyMode safety);

    void good(Condition condition, const QString& detail);
    void found(Condition condition, Verdict verdict, const QString& cause, const QString& detail,
               const QString& fix);
    bool isGood(Condition condition) const;
    /// At most so long, never past the examination's own end.
    Deadline within(int ms) const;

    const Patient& patient_;
    const Deadline& deadline_;
    const std::function<void(const Finding&)>& each_;
    std::map<Condition, Finding> findings_;

    QString address_;  ///< resolved
    std::optional<SoftwareVersion> version_;
};

}  // namespace tiller::doctor
