// SPDX-License-Identifier: MIT
#pragma once

// State of one examination. Private to robot/doctor.

#include <QCoreApplication>
#include <map>
#include <optional>

#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/doctor/examination.h"

namespace tiller::doctor {

/// Translation context of the doctor's texts, for lupdate.
struct DoctorText {
    Q_DECLARE_TR_FUNCTIONS(Doctor)
};

/// The findings so far and the remaining time of one examination.
class Examiner {
public:
    Examiner(const Patient& examined, const Deadline& end, const std::function<void(const Finding&)>& each)
        : patient(examined), deadline(end), each_(each) {}

    void good(Condition condition, const QString& detail);
    void found(Condition condition, Verdict verdict, const QString& cause, const QString& detail,
               const QString& fix);
    /// Discards the findings for a condition, so that the next finding replaces them.
    void forget(Condition condition) { findings_.erase(condition); }
    bool isGood(Condition condition) const;
    /// Returns one finding per condition. Conditions that were not examined are Skipped.
    Report report() const;
    /// Returns a deadline in `ms` milliseconds, or at the end of the examination if that is earlier.
    Deadline within(int ms) const;

    const Patient& patient;
    const Deadline& deadline;
    QString address;  ///< after name resolution
    std::optional<SoftwareVersion> version;

private:
    const std::function<void(const Finding&)>& each_;
    std::map<Condition, Finding> findings_;
};

// The steps of the examination, in order. Each step adds its findings.

/// Returns  false if there is no usable address
bool examineAddress(Examiner& examiner);
void examinePorts(Examiner& examiner);
void examineService(Examiner& examiner);
void examineRegisters(Examiner& examiner);
void examineModel(Examiner& examiner);
void examineData(Examiner& examiner);

}  // namespace tiller::doctor
