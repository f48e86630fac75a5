// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/simulation_chip.h"

#include <QPainter>
#include <QPainterPath>

#include "widgets/common/theme.h"

namespace tiller {

SimulationChip::SimulationChip(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("simulationChip"));
    setAccessibleName(tr("Simulation"));
    setToolTip(tr("This robot is simulated. No real robot moves."));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void SimulationChip::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(rect()), kCornerRadius, kCornerRadius);
    painter.fillPath(outline, theme.simulation);
    painter.setClipPath(outline);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.simulationStripe);
    const double h = height();
    constexpr double kStripe = 14;
    for (double x = -h; x < width(); x += 2 * kStripe) {
        painter.drawPolygon(QPolygonF({{x, h}, {x + kStripe, h}, {x + kStripe + h, 0}, {x + h, 0}}));
    }
    QFont font = textFont(width() >= 140 ? 15 : 13, QFont::Bold);
    font.setLetterSpacing(QFont::AbsoluteSpacing, width() >= 140 ? 1.0 : 0.3);
    painter.setFont(font);
    painter.setPen(theme.simulationText);
    painter.drawText(rect(), Qt::AlignCenter, tr("SIMULATION"));
}

}  // namespace tiller

#include "moc_simulation_chip.cpp"
