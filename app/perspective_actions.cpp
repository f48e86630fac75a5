// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/perspective_actions.h"

#include <QActionGroup>
#include <QDialog>
#include <QFontMetrics>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/action_table.h"
#include "widgets/common/theme.h"

namespace tiller::app {
namespace {

/// Width of the button that shows the current perspective [px]. Constant, although the names have different
/// lengths.
constexpr int kKeyWidth = 150;

}  // namespace

PerspectiveActions::PerspectiveActions(ActionTable& table, Perspectives& perspectives, Hooks hooks,
                                       QWidget& window)
    : QObject(&window)
    , table_(table)
    , perspectives_(perspectives)
    , hooks_(std::move(hooks))
    , window_(window)
    , group_(new QActionGroup(this)) {
    list();
    addCommands();
    connect(&perspectives_, &Perspectives::listChanged, this, &PerspectiveActions::list);
    connect(&perspectives_, &Perspectives::currentChanged, this, &PerspectiveActions::showCurrent);
    showCurrent();
}

QString PerspectiveActions::ownOnly(const QString& what) const {
    return perspectives_.current().builtIn ? what : QString();
}

void PerspectiveActions::addCommands() {
    const auto own = [this](const QString& what) {
        return [this, what](const SessionState&) { return ownOnly(what); };
    };
    table_.add({"perspective.save",
                tr("Save perspective"),
                tr("Saves the current panel layout to the current perspective."),
                {},
                [this] { perspectives_.save(); },
                own(tr("This perspective is built in. Save it under a different name."))});
    table_.add({"perspective.saveAs",
                tr("Save perspective as…"),
                tr("Saves the current panel layout under a new name."),
                {},
                [this] {
                    askForName(tr("Save perspective as"), {}, {},
                               [this](const QString& name) { perspectives_.saveAs(name); });
                }});
    table_.add({"perspective.rename",
                tr("Rename perspective…"),
                tr("Renames the current perspective."),
                {},
                [this] {
                    const Perspectives::Entry current = perspectives_.current();
                    askForName(
                        tr("Rename perspective"), current.name, current.id,
                        [this, current](const QString& name) { perspectives_.rename(current.id, name); });
                },
                own(tr("This perspective is built in and cannot be renamed."))});
    table_.add({"perspective.delete",
                tr("Delete perspective…"),
                tr("Deletes the current perspective. The panel layout does not change."),
                {},
                [this] { askToDelete(); },
                own(tr("This perspective is built in and cannot be deleted."))});
}

// Creates the commands again if the list has changed, because their texts contain the names of the
// perspectives.
void PerspectiveActions::list() {
    const QList<Perspectives::Entry> entries = perspectives_.all();
    if (entries != listed_) {
        listed_ = entries;
        for (QAction* action : std::exchange(choices_, {})) {
            group_->removeAction(action);
            table_.remove(action);
        }
        for (const Perspectives::Entry& entry : entries) {
            QAction* action =
                table_.add({"perspective." + entry.id, tr("Perspective %1").arg(entry.name), entry.help,
                            entry.shortcut, [this, id = entry.id] { perspectives_.choose(id); }});
            action->setCheckable(true);
            action->setData(entry.id);
            group_->addAction(action);
            choices_.append(action);
        }
        fillMenu();
    }
    showCurrent();
}

void PerspectiveActions::showCurrent() {
    const Perspectives::Entry current = perspectives_.current();
    for (QAction* action : std::as_const(choices_)) {
        action->setChecked(action->data().toString() == current.id);
    }
    if (key_ != nullptr) {
        // Use the font of the style sheet, because it may not have been applied to the button yet.
        const QFontMetrics metrics(textFont(14));
        const QString arrow = QStringLiteral(" ▾");
        const int room = kKeyWidth - 16 - metrics.horizontalAdvance(arrow);
        key_->setText(metrics.elidedText(current.name, Qt::ElideRight, room) + arrow);
        key_->setAccessibleName(tr("Perspective %1").arg(current.name));
        key_->setToolTip(
            tr("Perspective %1. Select a panel layout, or save the current layout.").arg(current.name));
    }
    hooks_.refresh();
}

void PerspectiveActions::fill(QMenu& menu) {
    menu_ = &menu;
    menu.setToolTipsVisible(true);
    fillMenu();
}

void PerspectiveActions::fillMenu() {
    if (menu_ != nullptr) {
        menu_->clear();
        menu_->addActions(choices_);
        menu_->addSeparator();
        for (const char* id :
             {"perspective.save", "perspective.saveAs", "perspective.rename", "perspective.delete"}) {
            menu_->addAction(table_.find(QLatin1String(id)));
        }
        if (QAction* reset = table_.find("view.reset")) {
            menu_->addSeparator();
            menu_->addAction(reset);
        }
    }
}

QToolButton* PerspectiveActions::key() {
    if (key_ == nullptr) {
        key_ = new QToolButton(&window_);
        key_->setObjectName("perspectiveKey");
        key_->setProperty("quiet", true);
        key_->setFont(textFont(13));
        key_->setFixedWidth(kKeyWidth);
        key_->setFocusPolicy(Qt::TabFocus);
        key_->setPopupMode(QToolButton::InstantPopup);
        key_->setMenu(menu_);
        connect(menu_, &QMenu::aboutToShow, this, [this] { hooks_.dialogOpens(); });
        showCurrent();
    }
    return key_;
}

void PerspectiveActions::askForName(const QString& title, const QString& proposal, const QString& except,
                                    const std::function<void(const QString&)>& done) {
    hooks_.dialogOpens();
    auto* dialog = new QDialog(&window_);
    dialog->setObjectName("perspectiveDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setMinimumWidth(460);
    auto* name = new QLineEdit(proposal);
    name->setObjectName("perspectiveName");
    name->setAccessibleName(tr("Perspective name"));
    auto* hint = new QLabel;
    hint->setObjectName("perspectiveHint");
    hint->setWordWrap(true);
    hint->setProperty("role", "secondary");
    // Reserve the height of the longest hint, so that the layout does not change while the user types.
    hint->setMinimumHeight(2 * hint->fontMetrics().lineSpacing());
    auto* save = new QPushButton(tr("Save"));
    save->setObjectName("perspectiveSave");
    save->setProperty("primary", true);
    save->setDefault(true);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName("perspectiveCancel");
    cancel->setAutoDefault(false);

    auto* layout = new QVBoxLayout(dialog);
    auto* label = new QLabel(tr("Name"));
    label->setBuddy(name);
    layout->addWidget(label);
    layout->addWidget(name);
    layout->addWidget(hint);
    auto* keys = new QHBoxLayout;
    keys->addStretch(1);
    keys->addWidget(cancel);
    keys->addWidget(save);
    layout->addLayout(keys);

    const auto look = [this, hint, save, except](const QString& text) {
        const QString why = perspectives_.obstacle(text, except);
        hint->setText(why);
        save->setEnabled(why.isEmpty());
    };
    connect(name, &QLineEdit::textChanged, dialog, look);
    look(proposal);
    connect(save, &QPushButton::clicked, dialog, &QDialog::accept);
    connect(cancel, &QPushButton::clicked, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [name, done] { done(name->text()); });
    dialog->open();
    name->selectAll();
    name->setFocus();
}

void PerspectiveActions::askToDelete() {
    hooks_.dialogOpens();
    const Perspectives::Entry current = perspectives_.current();
    auto* question = new QMessageBox(&window_);
    question->setObjectName("perspectiveDelete");
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setWindowTitle(tr("Delete perspective"));
    question->setText(tr("Delete the perspective “%1”? This cannot be undone.").arg(current.name));
    QPushButton* remove = question->addButton(tr("Delete"), QMessageBox::DestructiveRole);
    remove->setObjectName("perspectiveDeleteYes");
    QPushButton* keep = question->addButton(tr("Keep"), QMessageBox::RejectRole);
    question->setDefaultButton(keep);
    question->setEscapeButton(keep);
    connect(remove, &QPushButton::clicked, this, [this, current] { perspectives_.remove(current.id); });
    question->open();
}

}  // namespace tiller::app

#include "moc_perspective_actions.cpp"
