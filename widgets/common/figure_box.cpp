// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/figure_box.h"

#include <QWheelEvent>

namespace tiller {

FigureBox::FigureBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setButtonSymbols(NoButtons);
    setKeyboardTracking(false);
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(plain);
}

QValidator::State FigureBox::validate(QString& text, int& position) const {
    text.replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
    return QDoubleSpinBox::validate(text, position);
}

void FigureBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

}  // namespace tiller
