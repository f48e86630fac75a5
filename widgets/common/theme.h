// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The appearance of the application: colours by role, two colour schemes, and fonts. Widgets that paint
// themselves read Theme::current() while painting. All others use the palette and the style sheet set by
// applyTheme(). After a change, all widgets receive QEvent::StyleChange and are repainted.

#include <QColor>
#include <QFont>
#include <QString>
#include <array>

class QApplication;

namespace tiller {

enum class ColorScheme { Light, Dark };

/// Colours by role. The contrast of text is at least 4.5:1 on every surface on which the colour is used, and
/// 5:1 for states and values.
struct Theme {
    ColorScheme scheme;

    QColor background;  ///< background between the panels
    QColor panel;
    QColor raised;  ///< buttons, fields, header and status bar
    QColor border;  ///< borders and separators of 1 px; also the background of bars
    QColor hover;   ///< a raised button while the pointer is over it

    QColor text;
    QColor secondary;
    QColor disabledText;
    QColor inverse;      ///< background of the selected segment and the primary button
    QColor inverseText;  ///< text on `inverse`

    QColor moving;
    QColor movingText;  ///< text on `moving`
    QColor movingTint;  ///< background of the selected row and of the button that moves the arm
    QColor warning;     ///< text and icon
    QColor warningBackground;
    QColor alarm;  ///< text and icon; brighter in the dark scheme, for legibility
    QColor alarmBackground;
    QColor stop;      ///< the STOP button and chips of a stopped robot
    QColor stopText;  ///< text on `stop`
    QColor operatorNeeded;
    QColor operatorNeededText;  ///< text on `operatorNeeded`
    QColor simulation;
    QColor simulationStripe;
    QColor simulationText;  ///< text on `simulation` and `simulationStripe`
    QColor recording;

    QColor axisX, axisY, axisZ;       ///< bars, arrows, lines
    std::array<QColor, 3> axisTexts;  ///< the same colours with sufficient contrast for text
    std::array<QColor, 6> curves;

    bool isDark() const { return scheme == ColorScheme::Dark; }
    /// axis  0 X, 1 Y, 2 Z
    const QColor& axis(int axis) const { return axis == 0 ? axisX : axis == 1 ? axisY : axisZ; }

    static const Theme& light();
    static const Theme& dark();
    static const Theme& of(ColorScheme scheme) { return scheme == ColorScheme::Dark ? dark() : light(); }
    /// The theme that was applied last. Initially the light theme.
    /// Threads  GUI
    static const Theme& current();
};

/// Sets palette, style sheet and font of the whole application.
/// Threads  GUI
void applyTheme(QApplication& application, const Theme& theme);

/// Selects the light theme for painting on paper: Theme::current() is the light theme during the lifetime of
/// the object. The application does not change.
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

/// Corner radius of panels and buttons [px].
inline constexpr int kCornerRadius = 6;

/// The application font, with digits of equal width.
QFont textFont(int pixelSize, QFont::Weight weight = QFont::Normal);
/// Fixed-width font for columns of numbers.
QFont numberFont(int pixelSize, QFont::Weight weight = QFont::Normal);

/// WCAG 2 contrast ratio of two opaque colours, 1 ... 21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace tiller
