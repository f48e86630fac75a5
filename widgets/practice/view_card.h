// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A card in the lower left corner of a view. It is an overlay that does not move other elements. Its size
// depends only on the view. Folding reduces the card to its title. The card folds automatically if the view
// is too small.

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace tiller {

class ViewCard : public QFrame {
    Q_OBJECT

public:
    /// name    object name, and prefix of the object names of the buttons: "name.fold", "name.close"
    /// height  preferred height [px]; 0: height of the content
    ViewCard(const QString& name, const QString& title, int height, QWidget& view);

    void setTitle(const QString& title);
    QString title() const;
    bool isFolded() const;
    void setFolded(bool folded);
    /// Shows the card without taking the focus.
    void open();
    /// Like open(), but folds the card if it would cover a large part of the view. Use this for a card that
    /// opens automatically.
    void openQuietly();
    /// Hides the card. If the card has the focus, the focus moves to the view.
    void putAway();

    /// Height at the lower edge of the view that the folded card covers [px]; 0 while hidden or unfolded.
    int covered() const;

    static constexpr int kWidth = 306;  ///< [px]

Q_SIGNALS:
    /// The user pressed the close button. The owner may call putAway().
    void closeRequested();
    void coveredChanged();

protected:
    /// Layout of the content, which scrolls if it is too high.
    QVBoxLayout& content() { return *contentLayout_; }
    /// Buttons below the content, always visible.
    QHBoxLayout& keys() { return *keyLayout_; }
    /// Adds a widget above the buttons, always visible.
    void addAboveKeys(QWidget* widget);
    /// Enables or disables a control of the card. If the control is disabled while it has the focus, the
    /// focus moves to the view instead of to the next control of the window.
    void setUsable(QWidget& control, bool usable);

    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    int wantedHeight() const;
    int footHeight() const;

    QWidget& view_;
    int height_;
    bool folded_ = false;
    bool noRoom_ = false;
    QLabel* title_;
    QToolButton* fold_;
    QToolButton* close_;
    QScrollArea* scroll_;
    QWidget* inside_;
    QWidget* foot_;
    QVBoxLayout* contentLayout_;
    QVBoxLayout* footLayout_;
    QHBoxLayout* keyLayout_;
};

}  // namespace tiller
