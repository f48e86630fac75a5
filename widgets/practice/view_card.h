// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A card in the lower left corner of a view. It lies over the view and so moves nothing else; its size follows
// from the view's alone, so that nothing in it slides either. It can be folded to its title, and folds by
// itself where the view has no room for it.

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
    /// name    object name, and the beginning of those of its keys: "name.fold", "name.close"
    /// height  that it has where there is room [px]; 0: what its content needs
    ViewCard(const QString& name, const QString& title, int height, QWidget& view);

    void setTitle(const QString& title);
    QString title() const;
    bool isFolded() const;
    void setFolded(bool folded);
    /// Shows it in its place; asks for no focus.
    void open();
    /// As open(), folded where it would hide much of the view: for a card that nobody asked for.
    void openQuietly();
    /// Hides it. The focus, if it was in the card, goes to the view.
    void putAway();

    /// What the folded card takes of the view's lower edge [px]; 0 while it is hidden or unfolded.
    int covered() const;

    static constexpr int kWidth = 306;  ///< [px]

Q_SIGNALS:
    /// Its close key was pressed. Whoever made the card decides what that means.
    void closeRequested();
    /// covered() has changed.
    void coveredChanged();

protected:
    /// Where the content goes; it scrolls where it is too long.
    QVBoxLayout& content() { return *contentLayout_; }
    /// Below the content, always in sight.
    QHBoxLayout& keys() { return *keyLayout_; }
    /// Between the two, always in sight too.
    void addAboveKeys(QWidget* widget);
    /// Enables a control of the card, or not: one that has the focus hands it to the view, not on to whatever
    /// control of the window comes next.
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
