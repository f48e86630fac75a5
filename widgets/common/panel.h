// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A part of the window: a rounded surface with a title bar (title, subtitle, room for small controls and a
// hint at the right) and one content widget below.

#include <QFrame>
#include <QVector>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace tiller {

class ElidedLabel;

class Panel : public QFrame {
    Q_OBJECT

public:
    explicit Panel(const QString& title, QWidget* parent = nullptr);

    QString title() const;
    void setTitle(const QString& title);
    /// Grey words right behind the title.
    void setSubtitle(const QString& text);
    /// Grey words at the right end; elided when the panel is narrow.
    void setHint(const QString& text);
    /// Adds a small control at the right end of the title bar.
    void addHeaderWidget(QWidget* widget);
    /// The same, for what is there only where the panel is wide enough, and can be reached in another way too. The one
    /// added first goes first.
    void addFoldingHeaderWidget(QWidget* widget);
    /// Puts a widget in place of title and hint, a tab bar for instance. The bar keeps its height.
    void setHeaderWidget(QWidget* widget);
    /// Takes ownership; replaces what was there.
    void setContent(QWidget* content);
    QWidget* content() const { return content_; }

    static constexpr int kHeaderHeight = 34;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void foldHeader();

    QWidget* header_;
    QHBoxLayout* headerLayout_;
    QVBoxLayout* layout_;
    QLabel* title_;
    QLabel* subtitle_;
    ElidedLabel* hint_;
    QWidget* content_ = nullptr;
    QVector<QWidget*> folding_;
};

}  // namespace tiller
