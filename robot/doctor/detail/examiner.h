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

/// What one examination has found so far, and how long it may still take.
class Examiner {
public:
    Examiner(const Patient& examined, const Deadline& end, const std::function<void(const Finding&)>& each)
        : patient(examined), deadline(end), each_(each) {}

    void good(Condition condition, const QString& detail);
    void found(Condition condition, Verdict verdict, const QString& cause, const QString& detail,
               const QString& fix);
    /// What was found about it does not count: the next finding does.
    void forget(Condition condition) { findings_.erase(condition); }
    bool isGood(Condition condition) const;
    /// One finding for every condition: what was not looked at is Skipped.
    Report report() const;
    /// At most so long, never past the examination's own end.
    Deadline within(int ms) const;

    const Patient& patient;
    const Deadline& deadline;
    QString address;  ///< resolved
    std::optional<SoftwareVersion> version;

private:
    const std::function<void(const Finding&)>& each_;
    std::map<Condition, Finding> findings_;
};

// In this order; each reports what it finds.

/// Returns  false when there is no address to go on with
bool examineAddress(Examiner& examiner);
void examinePorts(Examiner& examiner);
void examineService(Examiner& examiner);
void examineRegisters(Examiner& examiner);
void examineModel(Examiner& examiner);
void examineData(Examiner& examiner);

}  // namespace tiller::doctor
