// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "resources/resources.h"
#include "widgets/common/style_sheet.h"

namespace tiller {

namespace {

constexpr char kSchemeProperty[] = "tillerColorScheme";

QPalette paletteOf(const Theme& t) {
    QPalette p;
    p.setColor(QPalette::Window, t.background);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.raised);
    p.setColor(QPalette::AlternateBase, t.panel);
    p.setColor(QPalette::ToolTipBase, t.raised);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::PlaceholderText, t.secondary);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::Button, t.raised);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::BrightText, t.alarm);
    p.setColor(QPalette::Highlight, t.movingTint);
    p.setColor(QPalette::HighlightedText, t.text);
    p.setColor(QPalette::Link, t.moving);
    p.setColor(QPalette::LinkVisited, t.operatorNeeded);
    p.setColor(QPalette::Light, t.raised);
    p.setColor(QPalette::Midlight, t.panel);
    p.setColor(QPalette::Mid, t.border);
    p.setColor(QPalette::Dark, t.secondary);
    p.setColor(QPalette::Shadow, t.border);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        p.setColor(QPalette::Disabled, role, t.disabledText);
    }
    return p;
}

double linearChannel(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
    return 0.2126 * linearChannel(c.redF()) + 0.7152 * linearChannel(c.greenF()) +
           0.0722 * linearChannel(c.blueF());
}

QFont font(const QStringList& families, QFont::StyleHint hint, int pixelSize, QFont::Weight weight) {
    QFont f;
    f.setFamilies(families);
    f.setStyleHint(hint);
    f.setPixelSize(pixelSize);
    f.setWeight(weight);
    return f;
}

}  // namespace

const Theme& Theme::light() {
    static const Theme theme = {
        .scheme = ColorScheme::Light,
        .background = QColor(0xE6, 0xE6, 0xE6),
        .panel = QColor(0xF2, 0xF2, 0xF2),
        .raised = QColor(0xFF, 0xFF, 0xFF),
        .border = QColor(0xCF, 0xD2, 0xD6),
        .hover = QColor(0xF7, 0xF8, 0xF9),
        .text = QColor(0x1A, 0x1A, 0x1A),
        .secondary = QColor(0x5A, 0x5A, 0x5A),
        .disabledText = QColor(0x6B, 0x6E, 0x72),
        .inverse = QColor(0x1A, 0x1A, 0x1A),
        .inverseText = QColor(0xFF, 0xFF, 0xFF),
        .moving = QColor(0x00, 0x72, 0xB2),
        .movingText = QColor(0xFF, 0xFF, 0xFF),
        .movingTint = QColor(0xDC, 0xE9, 0xF2),
        .warning = QColor(0x8A, 0x45, 0x00),
        .warningBackground = QColor(0xFF, 0xE2, 0xB8),
        .alarm = QColor(0xB0, 0x00, 0x20),
        .alarmBackground = QColor(0xFA, 0xDF, 0xE3),
        .stop = QColor(0xB0, 0x00, 0x20),
        .stopText = QColor(0xFF, 0xFF, 0xFF),
        .operatorNeeded = QColor(0x7B, 0x3F, 0xA0),
        .operatorNeededText = QColor(0xFF, 0xFF, 0xFF),
        .simulation = QColor(0x6A, 0x51, 0xA3),
        .simulationStripe = QColor(0x7E, 0x68, 0xB1),
        .simulationText = QColor(0xFF, 0xFF, 0xFF),
        .recording = QColor(0xB0, 0x00, 0x20),
        .axisX = QColor(0xD5, 0x5E, 0x00),
        .axisY = QColor(0x00, 0x9E, 0x73),
        .axisZ = QColor(0x00, 0x72, 0xB2),
        .axisTexts = {QColor(0xA8, 0x4A, 0x00), QColor(0x00, 0x6E, 0x50), QColor(0x00, 0x66, 0xA0)},
        .curves = {QColor(0x00, 0x72, 0xB2), QColor(0xD5, 0x5E, 0x00), QColor(0x00, 0x9E, 0x73),
                   QColor(0xCC, 0x79, 0xA7), QColor(0xE6, 0x9F, 0x00), QColor(0x56, 0xB4, 0xE9)},
    };
    return theme;
}

const Theme& Theme::dark() {
    static const Theme theme = {
        .scheme = ColorScheme::Dark,
        .background = QColor(0x1E, 0x21, 0x24),
        .panel = QColor(0x2A, 0x2E, 0x32),
        .raised = QColor(0x33, 0x38, 0x3D),
        .border = QColor(0x45, 0x4B, 0x52),
        .hover = QColor(0x3B, 0x41, 0x47),
        .text = QColor(0xEC, 0xEC, 0xEC),
        .secondary = QColor(0xA8, 0xAD, 0xB3),
        .disabledText = QColor(0x9E, 0xA3, 0xAA),
        .inverse = QColor(0xEC, 0xEC, 0xEC),
        .inverseText = QColor(0x1A, 0x1A, 0x1A),
        .moving = QColor(0x56, 0xB4, 0xE9),
        .movingText = QColor(0x10, 0x1A, 0x22),
        .movingTint = QColor(0x2F, 0x46, 0x57),
        .warning = QColor(0xE6, 0x9F, 0x00),
        .warningBackground = QColor(0x4A, 0x3A, 0x10),
        .alarm = QColor(0xFF, 0x85, 0x89),
        .alarmBackground = QColor(0x52, 0x25, 0x2A),
        .stop = QColor(0xB0, 0x00, 0x20),
        .stopText = QColor(0xFF, 0xFF, 0xFF),
        .operatorNeeded = QColor(0xCC, 0x79, 0xA7),
        .operatorNeededText = QColor(0x1A, 0x1A, 0x1A),
        .simulation = QColor(0xB3, 0x9D, 0xDB),
        .simulationStripe = QColor(0x9E, 0x8A, 0xC4),
        .simulationText = QColor(0x1A, 0x1A, 0x1A),
        .recording = QColor(0xFF, 0x85, 0x89),
        .axisX = QColor(0xFF, 0x8A, 0x3D),
        .axisY = QColor(0x2F, 0xCB, 0x9B),
        .axisZ = QColor(0x56, 0xB4, 0xE9),
        .axisTexts = {QColor(0xFF, 0x8A, 0x3D), QColor(0x2F, 0xCB, 0x9B), QColor(0x56, 0xB4, 0xE9)},
        .curves = {QColor(0x56, 0xB4, 0xE9), QColor(0xFF, 0x8A, 0x3D), QColor(0x2F, 0xCB, 0x9B),
                   QColor(0xCC, 0x79, 0xA7), QColor(0xE6, 0x9F, 0x00), QColor(0x9C, 0xD2, 0xF2)},
    };
    return theme;
}

const Theme& Theme::current() {
    const auto* app = QCoreApplication::instance();
    const bool dark = app != nullptr && app->property(kSchemeProperty).toBool();
    return dark ? Theme::dark() : Theme::light();
}

void applyTheme(QApplication& application, const Theme& theme) {
    initResources();  // the style sheet references images in the resources
    application.setProperty(kSchemeProperty, theme.isDark());
    if (application.style() == nullptr || application.styleSheet().isEmpty()) {
        application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    }
    application.setFont(textFont(15));
    application.setPalette(paletteOf(theme));
    application.setStyleSheet(styleSheet(theme));
}

PaperColors::PaperColors() : wasDark_(Theme::current().isDark()) {
    QCoreApplication::instance()->setProperty(kSchemeProperty, false);
}

PaperColors::~PaperColors() {
    QCoreApplication::instance()->setProperty(kSchemeProperty, wasDark_);
}

QFont textFont(int pixelSize, QFont::Weight weight) {
    static const QStringList families = {QStringLiteral("DejaVu Sans"), QStringLiteral("Bitstream Vera Sans"),
                                         QStringLiteral("Verdana"), QStringLiteral("Segoe UI"),
                                         QStringLiteral("Noto Sans")};
    return font(families, QFont::SansSerif, pixelSize, weight);
}

QFont numberFont(int pixelSize, QFont::Weight weight) {
    static const QStringList families = {QStringLiteral("DejaVu Sans Mono"),
                                         QStringLiteral("Bitstream Vera Sans Mono"), QStringLiteral("Menlo"),
                                         QStringLiteral("Consolas"), QStringLiteral("Noto Sans Mono")};
    return font(families, QFont::Monospace, pixelSize, weight);
}

double contrastRatio(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace tiller
