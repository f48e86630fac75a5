// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/comparison_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "widgets/common/format.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/notation.h"
#include "widgets/session/texts.h"

namespace tiller {

namespace {

using divergence::Quantity;

/// The texts of this file for the translators: lupdate finds them by this name.
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
        return ComparisonText::tr("%1: not compared, the recording has no %2; record all signals, to MCAP")
            .arg(name, fields.join(QStringLiteral(", ")));
    }
    if (!outcome.greatest) {
        return ComparisonText::tr("%1: no values").arg(name);
    }
    const QString limit = amountText(outcome.quantity, outcome.limit);
    if (!outcome.parted) {
        return ComparisonText::tr("%1: never beyond %2, at most %3 at %4 s")
            .arg(name, limit, amountText(outcome.quantity, outcome.greatest->amount),
                 seconds(*outcome.greatest));
    }
    return ComparisonText::tr("%1: beyond %2 from %3 s on (%4), at most %5 at %6 s")
        .arg(name, limit, seconds(*outcome.parted), partingMark(*outcome.parted),
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

QString partingMark(const divergence::Difference& parting) {
    const QString place = parting.joint < 0 ? ComparisonText::tr("TCP") : jointName(parting.joint);
    return ComparisonText::tr("%1 %2", "TCP 6.2 mm").arg(place, amountText(parting.quantity, parting.amount));
}

QString partingText(const divergence::Difference& parting) {
    const QString amount = amountText(parting.quantity, parting.amount);
    switch (parting.quantity) {
        case Quantity::JointPosition:
            return ComparisonText::tr("Arm and model part at %1 s: %2 is %3 off")
                .arg(seconds(parting), jointName(parting.joint), amount);
        case Quantity::TcpPosition:
            return ComparisonText::tr("Arm and model part at %1 s: the TCP is %2 off")
                .arg(seconds(parting), amount);
        case Quantity::JointCurrent:
            return ComparisonText::tr("Arm and model part at %1 s: %2 needs %3 more or less than it should")
                .arg(seconds(parting), jointName(parting.joint), amount);
        case Quantity::TcpForce:
            return ComparisonText::tr("Arm and model part at %1 s: a force of %2 pushes the TCP")
                .arg(seconds(parting), amount);
    }
    return {};
}

QString reportText(const divergence::Report& report) {
    if (const auto first = report.first()) {
        return partingText(*first);
    }
    const QString model = QString::fromLatin1(robotModel(report.model).name);
    return report.firstCompared
               ? ComparisonText::tr("The arm did what the model of a %1 does").arg(model)
               : ComparisonText::tr(
                     "Nothing could be compared: the arm had no power all the time, or was led by hand.");
}

QString reportDetails(const divergence::Report& report) {
    QStringList lines;
    if (report.partedFromStart()) {
        lines << ComparisonText::tr(
            "They never were together: check the payload that the robot was told of, the model, and what "
            "touches the arm.");
    } else if (report.first()) {
        lines << ComparisonText::tr(
            "From there on something pushed or held the arm, its load was another one, or a joint did not "
            "follow.");
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
                "This recording cannot be compared with a model: it lacks what the joints were told, or "
                "where "
                "they were. Record all signals, to MCAP.");
        case ErrorCode::InvalidArgument:
            return ComparisonText::tr(
                "This recording cannot be compared with a model: its rows are too far apart. Record every "
                "packet.");
        case ErrorCode::Cancelled:
            return ComparisonText::tr("Not compared with the model of the arm.");
        default:
            return texts::errorText(error);
    }
}

}  // namespace tiller
