// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The look of the application: every colour by its role, the two schemes, and the fonts. Widgets that paint
// themselves ask Theme::current() while painting; everything else gets its look from the palette and the
// style sheet that applyTheme() sets. A change reaches every widget as QEvent::StyleChange and repaints it.

#include <QColor>
#include <QFont>
#include <QString>
#include <array>

class QApplication;

namespace tiller {

enum class ColorScheme { Light, Dark };

/// Colours by role. Text roles have a contrast of at least 4.5:1 on every surface they are used on, state and
/// values 5:1.
struct Theme {
    ColorScheme scheme;

    QColor background;  ///< behind the panels
    QColor panel;
    QColor raised;  ///< keys, fields, header and status line
    QColor border;  ///< 1 px lines around and between; also tracks of bars
    QColor hover;   ///< a raised key under the pointer

    QColor text;
    QColor secondary;
    QColor disabledText;
    QColor inverse;      ///< filled: the selected segment, the one primary button
    QColor inverseText;  ///< on `inverse`

    QColor moving;
    QColor movingText;  ///< on `moving`
    QColor movingTint;  ///< behind the selected row and the key that moves the arm
    QColor warning;     ///< text and icon
    QColor warningBackground;
    QColor alarm;  ///< text and icon; in the dark scheme brighter than the table's, which is too dim for text
    QColor alarmBackground;
    QColor stop;      ///< the STOP key and chips of a stopped robot
    QColor stopText;  ///< on `stop`
    QColor operatorNeeded;
    QColor operatorNeededText;  ///< on `operatorNeeded`
    QColor simulation;
    QColor simulationStripe;
    QColor simulationText;  ///< on both
    QColor recording;

    QColor axisX, axisY, axisZ;       ///< bars, arrows, lines
    std::array<QColor, 3> axisTexts;  ///< the same, dark or bright enough for letters
    std::array<QColor, 6> curves;

    bool isDark() const { return scheme == ColorScheme::Dark; }
    /// axis  0 X, 1 Y, 2 Z
    const QColor& axis(int axis) const { return axis == 0 ? axisX : axis == 1 ? axisY : axisZ; }

    static const Theme& light();
    static const Theme& dark();
    static const Theme& of(ColorScheme scheme) { return scheme == ColorScheme::Dark ? dark() : light(); }
    /// The one applied to the application last; light before that.
    /// Threads  GUI
    static const Theme& current();
};

/// Sets palette, style sheet and font of the whole application.
/// Threads  GUI
void applyTheme(QApplication& application, const Theme& theme);

/// While it lives, Theme::current() is the light one, for what is painted on paper; the application keeps its look.
/// Threads  GUI
class PaperColors {
public:
    PaperColors();
    ~PaperColors();
    PaperColors(const PaperColors&) = delete;
    PaperColors& operator=(const PaperColors&) = delete;

private:
    bool wasDark_;
};

/// Corner radius of panels and keys [px].
inline constexpr int kCornerRadius = 6;

/// The application's typeface (its digits all have one width).
QFont textFont(int pixelSize, QFont::Weight weight = QFont::Normal);
/// Fixed-width companion for columns of numbers.
QFont figureFont(int pixelSize, QFont::Weight weight = QFont::Normal);

/// WCAG 2 contrast ratio of two opaque colours, 1 ... 21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace tiller
