// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/comparison_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "robot/core/angles.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"

namespace tiller {

namespace {

constexpr double kMsPerSecondOfLimit = 1e3;
constexpr int kWidth = 440;  // [px]

}  // namespace

ComparisonDialog::ComparisonDialog(const divergence::Limits& limits, std::optional<RobotModelId> model,
                                   QWidget* parent)
    : QDialog(parent), model_(new ChoiceBox) {
    setObjectName(QStringLiteral("plots.comparison.dialog"));
    setWindowTitle(tr("Compare with the arm model"));
    auto* words =
        new QLabel(tr("The simulated arm follows the recorded joint targets, and its motion is compared with "
                      "the recorded motion. The model includes neither contact nor friction."));
    words->setWordWrap(true);
    words->setMinimumWidth(kWidth);
    model_->setObjectName(QStringLiteral("plots.comparison.model"));
    model_->setAccessibleName(tr("Arm model"));
    model_->setPlaceholderText(tr("Choose…"));
    for (const RobotModel& each : robotModels()) {
        model_->addItem(QString::fromLatin1(each.name), static_cast<int>(each.id));
    }
    model_->setCurrentIndex(model ? model_->findData(static_cast<int>(*model)) : -1);
    auto* form = new QFormLayout;
    form->addRow(tr("Arm"), model_);
    joint_ = box("joint", tr("Joint positions"), QStringLiteral("°"), toDegrees(limits.jointPosition), 360);
    tcp_ = box("tcp", tr("TCP position"), QLatin1Char(' ') + format::lengthUnit(),
               limits.tcpPosition / format::metresPerUnit(), 10 / format::metresPerUnit());
    current_ = box("current", tr("Joint currents"), QStringLiteral(" A"), limits.current, 100);
    force_ = box("force", tr("TCP force"), QStringLiteral(" N"), limits.force, 10'000);
    lasting_ = box("lasting", tr("Minimum duration"), QStringLiteral(" ms"),
                   limits.lasting * kMsPerSecondOfLimit, 60'000);
    for (DecimalSpinBox* each : {joint_, tcp_, current_, force_, lasting_}) {
        form->addRow(each->accessibleName(), each);
    }
    auto* none = new QLabel(tr("Signals with a limit of 0 are not compared."));
    none->setProperty("role", QStringLiteral("secondary"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    compare_ = buttons->button(QDialogButtonBox::Ok);
    compare_->setText(tr("Compare"));
    compare_->setObjectName(QStringLiteral("plots.comparison.accept"));
    compare_->setEnabled(model.has_value());
    connect(model_, &QComboBox::currentIndexChanged, this,
            [this](int index) { compare_->setEnabled(index >= 0); });
    connect(buttons, &QDialogButtonBox::accepted, this, &ComparisonDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(none);
    layout->addWidget(buttons);
}

DecimalSpinBox* ComparisonDialog::box(const char* name, const QString& text, const QString& unit,
                                      double value, double most) {
    auto* number = new DecimalSpinBox;
    number->setObjectName(QStringLiteral("plots.comparison.") + QLatin1String(name));
    number->setAccessibleName(text);
    number->setRange(0, most);
    number->setDecimals(3);
    number->setSuffix(unit);
    number->setValue(value);
    return number;
}

divergence::Limits ComparisonDialog::limits() const {
    divergence::Limits limits;
    limits.jointPosition = toRadians(joint_->value());
    limits.tcpPosition = tcp_->value() * format::metresPerUnit();
    limits.current = current_->value();
    limits.force = force_->value();
    limits.lasting = lasting_->value() / kMsPerSecondOfLimit;
    return limits;
}

std::optional<RobotModelId> ComparisonDialog::model() const {
    return model_->currentIndex() < 0
               ? std::nullopt
               : std::optional(static_cast<RobotModelId>(model_->currentData().toInt()));
}

void ComparisonDialog::accept() {
    for (DecimalSpinBox* each : {joint_, tcp_, current_, force_, lasting_}) {
        if (each->isRefused()) {
            each->setFocus();
            each->explainRefusal();
            return;
        }
    }
    QDialog::accept();
}

}  // namespace tiller

#include "moc_comparison_dialog.cpp"
