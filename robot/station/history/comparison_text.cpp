// SPDX-License-Identifier: MIT
#include "robot/station/history/comparison_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

using divergence::Quantity;

/// Translation context of this file for lupdate.
struct ComparisonText {
    Q_DECLARE_TR_FUNCTIONS(Comparison)
};

QString nameOf(Quantity quantity) {
    switch (quantity) {
        case Quantity::JointPosition:
            return ComparisonText::tr("Joint positions");
        case Quantity::TcpPosition:
            return ComparisonText::tr("TCP position");
        case Quantity::JointCurrent:
            return ComparisonText::tr("Joint currents");
        case Quantity::TcpForce:
            return ComparisonText::tr("TCP force");
    }
    return {};
}

QString nameOf(RobotModelId model) {
    return QString::fromLatin1(robotModel(model).name);
}

QString seconds(const divergence::Difference& difference) {
    return format::number(difference.seconds, 3);
}

QString outcomeLine(const divergence::Outcome& outcome) {
    const QString name = nameOf(outcome.quantity);
    if (!(outcome.limit > 0)) {
        return ComparisonText::tr("%1: not compared").arg(name);
    }
    if (!outcome.missing.empty()) {
        QStringList fields;
        for (const std::string& field : outcome.missing) {
            fields << QString::fromStdString(field);
        }
        return ComparisonText::tr(
                   "%1: not compared because the recording has no %2; record all signals to an MCAP file")
            .arg(name, fields.join(QStringLiteral(", ")));
    }
    if (!outcome.greatest) {
        return ComparisonText::tr("%1: no values").arg(name);
    }
    const QString limit = amountText(outcome.quantity, outcome.limit);
    if (!outcome.parted) {
        return ComparisonText::tr("%1: within %2 at all times, maximum %3 at %4 s")
            .arg(name, limit, amountText(outcome.quantity, outcome.greatest->amount),
                 seconds(*outcome.greatest));
    }
    return ComparisonText::tr("%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s")
        .arg(name, limit, seconds(*outcome.parted), deviationMark(*outcome.parted),
             amountText(outcome.quantity, outcome.greatest->amount), seconds(*outcome.greatest));
}

}  // namespace

QString amountText(Quantity quantity, double amount) {
    switch (quantity) {
        case Quantity::JointPosition:
            return format::degrees(amount);
        case Quantity::TcpPosition:
            return format::length(amount, 1);
        case Quantity::JointCurrent:
            return format::amperes(amount);
        case Quantity::TcpForce:
            return format::newtons(amount);
    }
    return {};
}

QString deviationMark(const divergence::Difference& parting) {
    const QString place = parting.joint < 0 ? ComparisonText::tr("TCP") : jointName(parting.joint);
    return ComparisonText::tr("%1 %2", "TCP 6.2 mm").arg(place, amountText(parting.quantity, parting.amount));
}

QString deviationText(const divergence::Difference& parting) {
    const QString amount = amountText(parting.quantity, parting.amount);
    switch (parting.quantity) {
        case Quantity::JointPosition:
            return ComparisonText::tr("Arm and model diverge at %1 s: %2 deviates by %3")
                .arg(seconds(parting), jointName(parting.joint), amount);
        case Quantity::TcpPosition:
            return ComparisonText::tr("Arm and model diverge at %1 s: the TCP deviates by %2")
                .arg(seconds(parting), amount);
        case Quantity::JointCurrent:
            return ComparisonText::tr("Arm and model diverge at %1 s: the current of %2 deviates by %3")
                .arg(seconds(parting), jointName(parting.joint), amount);
        case Quantity::TcpForce:
            return ComparisonText::tr("Arm and model diverge at %1 s: a force of %2 acts on the TCP")
                .arg(seconds(parting), amount);
    }
    return {};
}

QString reportText(const divergence::Report& report) {
    if (report.otherModel) {
        return ComparisonText::tr("The recorded arm is a %1, but it was compared with the model of a %2")
            .arg(nameOf(*report.otherModel), nameOf(report.model));
    }
    if (const auto first = report.first()) {
        return deviationText(*first);
    }
    const QString model = nameOf(report.model);
    if (report.firstCompared && !report.isModelConfirmed) {
        return ComparisonText::tr(
                   "No deviation from the model of a %1, but the recorded values may fit other models too")
            .arg(model);
    }
    const bool isPartial = std::ranges::any_of(
        report.outcomes, [](const divergence::Outcome& each) { return !each.missing.empty(); });
    if (report.firstCompared && isPartial) {
        return ComparisonText::tr(
                   "The compared values match the model of a %1; other values were not recorded")
            .arg(model);
    }
    return report.firstCompared ? ComparisonText::tr("The motion matches the model of a %1").arg(model)
                                : ComparisonText::tr(
                                      "Nothing to compare: the arm was powered off or guided by hand for the "
                                      "whole recording.");
}

QString reportDetails(const divergence::Report& report) {
    QStringList lines;
    if (report.otherModel) {
        lines << ComparisonText::tr("Compare the recording with the model of a %1.")
                     .arg(nameOf(*report.otherModel));
    } else if (report.partedFromStart()) {
        lines << ComparisonText::tr(
            "The arm deviates from the model from the start of the recording. Check the payload and the "
            "robot model, and check whether something was touching the arm.");
    } else if (report.first()) {
        lines << ComparisonText::tr(
            "From this time on, the arm was pushed or held, its payload differed, or a joint did not follow "
            "its target.");
    }
    for (const divergence::Outcome& outcome : report.outcomes) {
        lines << outcomeLine(outcome);
    }
    return lines.join(QLatin1Char('\n'));
}

QString comparisonError(const Error& error) {
    switch (error.code) {
        case ErrorCode::FieldUnknown:
            return ComparisonText::tr(
                "This recording cannot be compared with a model: target or actual joint positions are "
                "missing. Record all signals to an MCAP file.");
        case ErrorCode::InvalidArgument:
            return ComparisonText::tr(
                "This recording cannot be compared with a model: its sampling interval is too long. Record "
                "every packet.");
        case ErrorCode::Cancelled:
            return ComparisonText::tr("Not compared with the arm model.");
        default:
            return texts::errorText(error);
    }
}

}  // namespace tiller
