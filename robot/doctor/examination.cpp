// SPDX-License-Identifier: MIT
#include "robot/doctor/examination.h"

#include <algorithm>

#include "robot/doctor/detail/examiner.h"

namespace tiller::doctor {

Patient patientAt(const Text& host, int portOffset) {
    Patient patient;
    patient.host = host;
    Ports& p = patient.ports;
    for (int* port : {&p.rtde, &p.primary, &p.secondary, &p.realtime, &p.dashboard}) {
        *port += portOffset;
    }
    if (portOffset != 0) {
        p.robotApi += portOffset;
    }
    return patient;
}

Report examine(const Patient& patient, const Deadline& deadline,
               const std::function<void(const Finding&)>& each) {
    Examiner examiner(patient, deadline, each);
    if (examineAddress(examiner)) {
        examinePorts(examiner);
    }
    if (examiner.isGood(Condition::Host)) {
        examineService(examiner);
        examineRegisters(examiner);
        examineModel(examiner);
        examineData(examiner);
    }
    return examiner.report();
}

Report Examiner::report() const {
    Report report;
    for (int i = 0; i < kConditionCount; ++i) {
        const auto condition = static_cast<Condition>(i);
        if (const auto it = findings_.find(condition); it != findings_.end()) {
            report.push_back(it->second);
            continue;
        }
        report.push_back({condition, Verdict::Skipped, {}, {}, {}});
        if (each_) {
            each_(report.back());
        }
    }
    return report;
}

void Examiner::good(Condition condition, const QString& detail) {
    found(condition, Verdict::Good, {}, detail, {});
}

void Examiner::found(Condition condition, Verdict verdict, const QString& cause, const QString& detail,
                     const QString& fix) {
    const Finding finding{condition, verdict, cause, detail, fix};
    if (findings_.emplace(condition, finding).second && each_) {
        each_(finding);
    }
}

bool Examiner::isGood(Condition condition) const {
    const auto it = findings_.find(condition);
    return it != findings_.end() &&
           (it->second.verdict == Verdict::Good || it->second.verdict == Verdict::Attention);
}

Deadline Examiner::within(int ms) const {
    return Deadline::after(std::min(std::chrono::milliseconds(ms), deadline.remaining()), deadline.token());
}

}  // namespace tiller::doctor
