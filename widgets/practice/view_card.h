// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A card in the lower left corner of a view, as an overlay that does not move other elements; its size depends on
// the view only. It can be folded to its title, and is folded automatically if the view is too small.

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
    /// name    object name, and prefix of the names of its buttons: "name.fold", "name.close"
    /// height  preferred height [px]; 0: height of the content
    ViewCard(const QString& name, const QString& title, int height, QWidget& view);

    void setTitle(const QString& title);
    QString title() const;
    bool isFolded() const;
    void setFolded(bool folded);
    /// Shows the card without taking the focus.
    void open();
    /// As open(), but folded if it would cover a large part of the view: for a card that opens automatically.
    void openQuietly();
    /// Hides the card. If it has the focus, the view gets it.
    void putAway();

    /// Height of the folded card at the lower edge of the view [px]; 0 while hidden or unfolded.
    int covered() const;

    static constexpr int kWidth = 306;  ///< [px]

Q_SIGNALS:
    /// The close button was pressed; the owner decides what happens.
    void closeRequested();
    /// covered() has changed.
    void coveredChanged();

protected:
    /// Layout of the content, which scrolls if it is too long.
    QVBoxLayout& content() { return *contentLayout_; }
    /// Buttons below the content, always visible.
    QHBoxLayout& keys() { return *keyLayout_; }
    /// Adds a widget above the buttons, always visible.
    void addAboveKeys(QWidget* widget);
    /// Enables or disables a control of the card: when it has the focus, the view gets it instead of the next
    /// control of the window.
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
