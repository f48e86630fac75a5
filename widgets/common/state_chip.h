// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A small field of the header with a caption and, below it, a state as symbol and text. It is grey in the
// normal state and coloured only if attention or an action is required.

#include <QFont>
#include <QWidget>

namespace tiller {

class StateChip : public QWidget {
    Q_OBJECT

public:
    /// Colour is used only if attention is required.
    enum class Emphasis { Normal, Moving, Warning, Alarm, OperatorNeeded, Muted };
    Q_ENUM(Emphasis)
    /// Symbol in front of the text, so that colour is never the only indication of a state.
    enum class Shape {
        None,
        Circle,
        Dot,
        Triangle,
        WarningTriangle,
        Octagon,
        Hand,
        Square,
        Power,
        Bolt,
        Bars,
        Cross,
        DownArrow,
        DoubleArrow,
        Pause
    };
    Q_ENUM(Shape)

    explicit StateChip(const QString& caption, QWidget* parent = nullptr);

    QString caption() const { return caption_; }
    /// Part of the caption that is elided first: after " · " (Behind) or before it (Before).
    enum class ElidedPart { Behind, Before };
    void setCaption(const QString& caption, ElidedPart elidedPart = ElidedPart::Behind);
    /// The caption as elided for the current width.
    QString shownCaption() const;
    QString text() const { return text_; }
    Emphasis emphasis() const { return emphasis_; }
    Shape shape() const { return shape_; }
    /// advice  meaning and suggested action, for the tooltip; the tooltip also contains the text if it is
    /// elided
    void setState(const QString& text, Shape shape, Emphasis emphasis, const QString& advice = {});
    /// Sets up to two letters inside the octagon or next to other symbols. They distinguish states with the
    /// same symbol.
    void setMark(const QString& mark);
    QString mark() const { return mark_; }
    /// Selects the fixed-width font, for numbers.
    void setNumberFont(bool figures);
    /// Selects smaller text and margins, for a narrow window.
    void setDense(bool dense);
    /// Sets a minimum width that fits the caption and this number of characters of the value. Longer values
    /// are elided.
    void setLeastCharacters(int characters);
    /// Minimum width for this caption and a value that is elided to the number of characters set by
    /// setLeastCharacters() [px].
    int leastRoom(const QString& caption) const;
    /// Sets a fixed width [px]. Texts that do not fit use a smaller font, then a second line, and are then
    /// elided.
    void setRoom(int width);
    /// Smallest width at which this value is not elided [px].
    int minWidth(const QString& text, Shape shape, Emphasis emphasis, const QString& mark) const;
    /// True if the value is not elided at this width.
    bool isWhole() const { return fittedText().isWhole; }
    void setMenuArrow(bool arrow);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    static constexpr int kHeight = 52;

Q_SIGNALS:
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    int padding() const;
    QFont valueFont() const;
    struct FittedText {
        QFont font;
        QString text;          ///< one or two lines
        bool isWhole = false;  ///< not elided
    };
    /// The value on one line in the largest font that fits. If it does not fit, two lines, or elided text.
    FittedText fittedText() const;
    int valueRoom() const;
    int widthFor(const QString& value, const QString& caption) const;
    static int roomOf(Shape shape, const QString& mark);
    int shapeRoom() const { return roomOf(shape_, mark_); }
    static bool isStrong(Emphasis e) { return e != Emphasis::Normal && e != Emphasis::Muted; }
    bool isStrong() const { return isStrong(emphasis_); }
    /// The part of the caption that is never elided.
    QString leastCaption() const { return leastCaption(caption_); }
    QString leastCaption(const QString& caption) const;
    void showTip();

    QString caption_;
    ElidedPart elidedPart_ = ElidedPart::Behind;
    QString text_;
    QString mark_;
    QString advice_;
    Shape shape_ = Shape::None;
    Emphasis emphasis_ = Emphasis::Normal;
    bool figures_ = false;
    bool menuArrow_ = false;
    int leastCharacters_ = 4;
    int room_ = 0;  ///< fixed width [px]; 0: depends on the text
    bool dense_ = false;
};

}  // namespace tiller
