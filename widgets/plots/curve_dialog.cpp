// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve_dialog.h"

#include <QColorDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <optional>

#include "widgets/common/choice_box.h"

namespace tiller {

namespace {

constexpr int kCurveDialogWidth = 380;  // [px]
constexpr QSize kColorSample(28, 14);

/// Accepts a decimal comma and the typographic minus sign.
std::optional<double> numberIn(QString text) {
    text =
        text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

QString exactNumber(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

}  // namespace

CurveDialog::CurveDialog(const Choice& choice, const QColor& automatic,
                         std::function<QString(const Choice&)> apply, QWidget* parent)
    : QDialog(parent)
    , choice_(choice)
    , automatic_(automatic)
    , apply_(std::move(apply))
    , color_(new QPushButton)
    , usual_(new QPushButton(tr("Automatic")))
    , line_(new ChoiceBox)
    , axis_(new ChoiceBox)
    , problem_(new QLabel) {
    setObjectName(QStringLiteral("plots.curve.dialog"));
    setWindowTitle(tr("Curve"));
    setAttribute(Qt::WA_DeleteOnClose);
    const auto edit = [](const char* name, const QString& text, const QString& accessibleName) {
        auto* result = new QLineEdit(text);
        result->setObjectName(QStringLiteral("plots.curve.") + QLatin1String(name));
        result->setAccessibleName(accessibleName);
        return result;
    };
    name_ = edit("name", choice.signal.name, tr("Name"));
    unit_ = edit("unit", choice.signal.unit, tr("Unit"));
    scale_ = edit("scale", exactNumber(choice.signal.scale), tr("Scale"));
    offset_ = edit("offset", exactNumber(choice.signal.offset), tr("Offset"));
    scale_->setToolTip(tr("Displayed value = value × scale + offset"));
    offset_->setToolTip(scale_->toolTip());
    color_->setObjectName(QStringLiteral("plots.curve.color"));
    color_->setAccessibleName(tr("Choose the colour"));
    color_->setText(tr("Choose…"));
    color_->setAutoDefault(false);
    usual_->setObjectName(QStringLiteral("plots.curve.usualColor"));
    usual_->setAccessibleName(tr("Automatic colour"));
    usual_->setAutoDefault(false);
    connect(color_, &QPushButton::clicked, this, &CurveDialog::chooseColor);
    connect(usual_, &QPushButton::clicked, this, [this] {
        choice_.style.color = {};
        showColor();
    });
    auto* colors = new QHBoxLayout;
    colors->addWidget(color_, 1);
    colors->addWidget(usual_);
    line_->setObjectName(QStringLiteral("plots.curve.line"));
    line_->setAccessibleName(tr("Line"));
    line_->addItems({tr("Automatic"), tr("Solid"), tr("Dashed"), tr("Dotted")});
    line_->setCurrentIndex(static_cast<int>(choice.style.line));
    axis_->setObjectName(QStringLiteral("plots.curve.axis"));
    axis_->setAccessibleName(tr("Value axis"));
    axis_->addItems({tr("Left"), tr("Right")});
    axis_->setCurrentIndex(choice.style.right ? 1 : 0);
    problem_->setObjectName(QStringLiteral("plots.curve.problem"));
    problem_->setProperty("role", QStringLiteral("warning"));
    problem_->setWordWrap(true);
    problem_->setMinimumWidth(kCurveDialogWidth);
    auto* form = new QFormLayout;
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Unit"), unit_);
    form->addRow(tr("Scale"), scale_);
    form->addRow(tr("Offset"), offset_);
    form->addRow(tr("Colour"), colors);
    form->addRow(tr("Line"), line_);
    form->addRow(tr("Value axis"), axis_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("plots.curve.accept"));
    connect(buttons, &QDialogButtonBox::accepted, this, &CurveDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(problem_);
    layout->addWidget(buttons);
    showColor();
}

void CurveDialog::chooseColor() {
    const QColor color = choice_.style.color.isValid() ? choice_.style.color : automatic_;
    auto* dialog = new QColorDialog(color, this);
    dialog->setObjectName(QStringLiteral("plots.curve.colorDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& chosen) {
        choice_.style.color = chosen.toRgb();
        showColor();
    });
    dialog->open();
}

void CurveDialog::showColor() {
    QPixmap sample(kColorSample);
    sample.fill(choice_.style.color.isValid() ? choice_.style.color : automatic_);
    color_->setIcon(QIcon(sample));
    color_->setIconSize(kColorSample);
    usual_->setEnabled(choice_.style.color.isValid());
}

QString CurveDialog::refusal(Choice& choice) const {
    choice.signal.name = name_->text().simplified();
    choice.signal.unit = unit_->text().simplified();
    if (choice.signal.name.isEmpty()) {
        return tr("Enter a name.");
    }
    for (const QString& text : {choice.signal.name, choice.signal.unit}) {
        if (text.contains(QLatin1Char('=')) || text.contains(QLatin1Char('[')) ||
            text.contains(QLatin1Char(']'))) {
            return tr("Name and unit cannot contain = [ ].");
        }
    }
    const auto scale = numberIn(scale_->text());
    const auto offset = numberIn(offset_->text());
    if (!scale || *scale == 0) {
        return tr("Enter a number other than 0 as the scale.");
    }
    if (!offset) {
        return tr("Enter a number as the offset.");
    }
    choice.signal.scale = *scale;
    choice.signal.offset = *offset;
    choice.style.line = static_cast<CurveStyle::Line>(line_->currentIndex());
    choice.style.right = axis_->currentIndex() == 1;
    return apply_(choice);
}

void CurveDialog::accept() {
    Choice choice = choice_;
    if (const QString why = refusal(choice); !why.isEmpty()) {
        problem_->setText(QStringLiteral("▲ ") + why);
        return;
    }
    QDialog::accept();
}

}  // namespace tiller

#include "moc_curve_dialog.cpp"
