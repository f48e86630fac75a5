// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A small labelled box of the header: a caption, and below it one state as icon shape and words. Grey while
// all is normal; coloured only when a person must look or act.

#include <QWidget>

namespace tiller {

class StateChip : public QWidget {
    Q_OBJECT

public:
    /// Colour comes only with a reason to look.
    enum class Emphasis { Normal, Moving, Warning, Alarm, OperatorNeeded, Muted };
    Q_ENUM(Emphasis)
    /// Drawn in front of the words, so that no state is told by colour alone.
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
    /// What gives way when room is short: what stands behind " · ", or what stands before it.
    enum class GivesWay { Behind, Before };
    void setCaption(const QString& caption, GivesWay givesWay = GivesWay::Behind);
    /// As it is drawn at this width.
    QString shownCaption() const;
    QString text() const { return text_; }
    Emphasis emphasis() const { return emphasis_; }
    Shape shape() const { return shape_; }
    /// advice  what it means and what to do, as the tooltip; the text itself stands there too where it is
    /// elided
    void setState(const QString& text, Shape shape, Emphasis emphasis, const QString& advice = {});
    /// Up to two letters in (octagon) or beside the shape, which tell apart states that share it.
    void setMark(const QString& mark);
    QString mark() const { return mark_; }
    /// Numbers in the fixed-width face.
    void setFigures(bool figures);
    /// Smaller letters and margins, for a narrow window.
    void setDense(bool dense);
    /// Never narrower than the caption and this many characters of the value; the rest is elided.
    void setLeastCharacters(int characters);
    /// This wide whatever it says [px]: words that are longer get smaller letters, and are elided at last.
    void setRoom(int width);
    /// Nothing of the value is elided at this width.
    bool isWhole() const { return shownText() == text_; }
    /// Shows the little arrow of something that opens a menu.
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
    /// The size at which the value fits, no smaller than can be read.
    QFont fittingFont() const;
    int valueRoom() const;
    QString shownText() const;
    int widthFor(const QString& value, const QString& caption) const;
    int shapeRoom() const;
    bool isStrong() const { return emphasis_ != Emphasis::Normal && emphasis_ != Emphasis::Muted; }
    /// The part of the caption that is always there.
    QString leastCaption() const;
    void showTip();

    QString caption_;
    GivesWay givesWay_ = GivesWay::Behind;
    QString text_;
    QString mark_;
    QString advice_;
    Shape shape_ = Shape::None;
    Emphasis emphasis_ = Emphasis::Normal;
    bool figures_ = false;
    bool menuArrow_ = false;
    int leastCharacters_ = 4;
    int room_ = 0;  ///< 0: as wide as what it says
    bool dense_ = false;
};

}  // namespace tiller
