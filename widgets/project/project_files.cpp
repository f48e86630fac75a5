// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_files.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "robot/station/text/texts.h"

namespace tiller {
namespace {

// Causes of notices, see Notice::cause.
constexpr char kDamaged[] = "project.damaged";
constexpr char kSaving[] = "project.saving";
constexpr char kElsewhere[] = "project.elsewhere";
constexpr char kForeign[] = "project.foreign";
constexpr char kRefused[] = "project.refused";
constexpr char kKept[] = "project.kept";

QString withSuffix(const QString& path) {
    return QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".tiller") : path;
}

}  // namespace

QString projectFolder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents.isEmpty() ? QDir::homePath() : documents).filePath(QStringLiteral("Tiller"));
}

ProjectFiles::ProjectFiles(ProjectStore& store, Journal& journal, QObject* parent)
    : QObject(parent), journal_(journal), store_(store) {
    connect(&store_, &ProjectStore::copyKept, this, [this](const QString& copy) {
        journal_.add(Severity::Warning, tr("The damaged project file was kept as %1.").arg(copy));
    });
    connect(&store_, &ProjectStore::saveFailed, this, [this](const Error& error) {
        warn(tr("The project could not be saved"), error, QLatin1String(kSaving));
    });
    connect(&store_, &ProjectStore::saveRecovered, this, [this] {
        journal_.add(Severity::Info, tr("Changes are saved to %1 again.").arg(store_.name()));
        Q_EMIT noticeResolved(QLatin1String(kSaving));
    });
    connect(&store_, &ProjectStore::openElsewhere, this, &ProjectFiles::onOpenElsewhere);
    connect(&store_, &ProjectStore::freeAgain, this, [this] {
        Q_EMIT noticeResolved(QLatin1String(kElsewhere));
        journal_.add(Severity::Info,
                     tr("The other window closed %1. This window saves changes again.").arg(store_.name()));
    });
    connect(&store_, &ProjectStore::changedByOther, this, &ProjectFiles::onChangedByOther);
    connect(&store_, &ProjectStore::externalChangeResolved, this,
            [this] { Q_EMIT noticeResolved(QLatin1String(kForeign)); });
    connect(&store_, &ProjectStore::pathChanged, this, [this] {
        // Notices with these causes referred to the previous project.
        for (const char* cause : {kDamaged, kSaving, kElsewhere, kForeign, kRefused}) {
            Q_EMIT noticeResolved(QLatin1String(cause));
        }
    });
}

void ProjectFiles::warn(const QString& title, const Error& error, const QString& cause) {
    // In this context, VersionUnsupported refers to the version of the file format instead of the robot
    // software.
    const QString text =
        error.code == ErrorCode::VersionUnsupported
            ? tr("%1. Update Tiller to open the file. The file was not changed.").arg(error.context)
            : texts::errorText(error);
    journal_.add(Severity::Error, text);
    Q_EMIT noticeWanted({.title = title, .text = text, .cause = cause});
}

void ProjectFiles::onOpenElsewhere() {
    const QString title = tr("%1 is open in another window").arg(store_.name());
    const QString who = store_.otherOwner() ? store_.otherOwner()->toString() : QString();
    const QString text =
        tr("Opened by %1. Changes in this window are not saved to the file until you take over the project.")
            .arg(who);
    journal_.add(Severity::Warning, title + QStringLiteral(". ") + text);
    Q_EMIT noticeWanted({.title = title,
                         .text = text,
                         .accept = tr("Take over"),
                         .accepted = [this] { takeOver(); },
                         .other = tr("Save as a copy"),
                         .otherAccepted = [this] { keepBoth(); },
                         .dismiss = tr("View only"),
                         .cause = QLatin1String(kElsewhere)});
}

void ProjectFiles::onChangedByOther() {
    const QString title = tr("Another window or program has changed %1").arg(store_.name());
    const QString text =
        tr("“Keep both” saves the project of this window to a second file. “Reload” shows the new content. "
           "Tiller then offers to restore the unsaved changes at the next start.");
    journal_.add(Severity::Warning, title + QStringLiteral(". ") + text);
    // The first button must not discard work, because this notice may replace another notice under the
    // pointer.
    Q_EMIT noticeWanted({.title = title,
                         .text = text,
                         .accept = tr("Keep both"),
                         .accepted = [this] { keepBoth(); },
                         .other = tr("Reload"),
                         .otherAccepted = [this] { reload(); },
                         .dismiss = tr("Decide later"),
                         .cause = QLatin1String(kForeign)});
}

bool ProjectFiles::postponesAnswer() {
    isAnswerPostponed_ = refusesToReplace();
    return isAnswerPostponed_;
}

void ProjectFiles::save(QWidget* over) {
    if (store_.obstacle() != ProjectStore::Obstacle::None) {
        askAboutFile();
    } else if (store_.path().isEmpty()) {
        askToSave(over);
    } else if (const Result<void> saved = store_.saveNow(); !saved) {
        warn(tr("The project could not be saved"), saved.error(), QLatin1String(kSaving));
    } else {
        journal_.add(Severity::Info, tr("Saved %1").arg(store_.name()), Origin::Operator);
    }
}

void ProjectFiles::askAboutFile() {
    if (store_.obstacle() == ProjectStore::Obstacle::OpenElsewhere) {
        onOpenElsewhere();
    } else {
        onChangedByOther();
    }
}

void ProjectFiles::takeOver() {
    if (postponesAnswer()) {
        return;
    }
    Q_EMIT noticeResolved(QLatin1String(kElsewhere));
    if (const Result<void> taken = store_.takeOver(); !taken) {
        warn(tr("The project could not be taken over"), taken.error(), QLatin1String(kElsewhere));
    }
}

void ProjectFiles::reload() {
    if (postponesAnswer()) {
        return;
    }
    if (const Result<void> loaded = store_.reload(); !loaded) {
        warn(tr("The project could not be opened"), loaded.error(), QLatin1String(kDamaged));
    } else {
        journal_.add(Severity::Info, tr("Reloaded %1").arg(store_.name()));
    }
}

void ProjectFiles::keepBoth() {
    const Result<QString> copy = store_.keepBoth();
    if (!copy) {
        warn(tr("The project could not be saved"), copy.error(), QLatin1String(kSaving));
    } else {
        journal_.add(Severity::Info, tr("The project in this window is now %1.").arg(*copy));
    }
}

bool ProjectFiles::confirmsDiscard(const QString& name) {
    QMessageBox question(QMessageBox::Warning, tr("Discard changes"),
                         tr("The unsaved work in “%1” will be deleted. This cannot be undone.").arg(name),
                         QMessageBox::NoButton, QApplication::activeWindow());
    question.setObjectName(QStringLiteral("discardKept"));
    QPushButton* drop = question.addButton(tr("Discard changes"), QMessageBox::DestructiveRole);
    drop->setObjectName(QStringLiteral("discardKept.drop"));
    QPushButton* keep = question.addButton(tr("Cancel"), QMessageBox::RejectRole);
    keep->setObjectName(QStringLiteral("discardKept.keep"));
    question.setDefaultButton(keep);
    question.setEscapeButton(keep);
    question.exec();
    return question.clickedButton() == drop;
}

void ProjectFiles::offerKept() {
    const QList<project::KeptCopy> kept = project::keptCopies(store_.copyFolder());
    if (kept.isEmpty()) {
        return;
    }
    const project::KeptCopy newest = kept.first();
    const QString name = newest.name.isEmpty() ? tr("Untitled project") : newest.name;
    const QString title = tr("Unsaved work can be recovered");
    const QString text = tr("“%1” was changed on %2 and not saved to a file.")
                             .arg(name, QLocale().toString(newest.at.toLocalTime(), QLocale::ShortFormat));
    journal_.add(Severity::Warning, title + QStringLiteral(". ") + text);
    Q_EMIT noticeWanted({.title = title,
                         .text = text,
                         .accept = tr("Open"),
                         .accepted =
                             [this, newest] {
                                 if (!mayReplace(QApplication::activeWindow())) {
                                     return;
                                 }
                                 if (const Result<void> opened = store_.openKept(newest); !opened) {
                                     warn(tr("The project could not be opened"), opened.error(),
                                          QLatin1String(kDamaged));
                                 }
                                 offerKept();
                             },
                         .other = tr("Discard changes"),
                         .otherAccepted =
                             [this, newest, name] {
                                 if (!confirmsDiscard(name)) {
                                     offerKept();
                                     return;
                                 }
                                 project::CopyKeeper keeper(store_.copyFolder());
                                 keeper.adopt(newest);
                                 keeper.remove(0);
                                 offerKept();
                             },
                         .dismiss = tr("Ask again next time"),
                         .cause = QLatin1String(kKept)});
}

QString ProjectFiles::startingPlace() const {
    if (!store_.copyName().isEmpty()) {
        const QLatin1String suffix(".tiller");
        const QString& name = store_.copyName();
        return QDir(projectFolder()).filePath(name.endsWith(suffix) ? name : name + suffix);
    }
    return store_.path().isEmpty() ? projectFolder() : store_.path();
}

void ProjectFiles::askToOpen(QWidget* over) {
    if (refusesToReplace()) {
        return;
    }
    const QString path = QFileDialog::getOpenFileName(over, tr("Open project"), startingPlace(),
                                                      tr("Tiller projects (*.tiller)"));
    // Ask about unsaved work only after a file was selected.
    if (!path.isEmpty() && mayReplace(over)) {
        open(path);
    }
}

void ProjectFiles::askForNew(QWidget* over) {
    if (refusesToReplace()) {
        return;
    }
    QDir().mkpath(projectFolder());
    const QString path = QFileDialog::getSaveFileName(
        over, tr("New project"), store_.path().isEmpty() ? projectFolder() : QFileInfo(store_.path()).path(),
        tr("Tiller projects (*.tiller)"), nullptr, QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty()) {
        return;
    }
    startNew(withSuffix(path), over);
}

void ProjectFiles::startNew(const QString& path, QWidget* over) {
    if (QFileInfo::exists(path)) {
        journal_.add(Severity::Warning,
                     tr("%1 already exists. Choose a different name for the new project.").arg(path));
        return;
    }
    if (mayReplace(over)) {
        open(path);
    }
}

void ProjectFiles::askToSave(QWidget* over) {
    if (store_.path().isEmpty()) {
        QDir().mkpath(projectFolder());
    }
    const QString path = QFileDialog::getSaveFileName(over, tr("Save project"), startingPlace(),
                                                      tr("Tiller projects (*.tiller)"));
    if (!path.isEmpty()) {
        saveAs(path);
    }
}

void ProjectFiles::open(const QString& path) {
    const Result<void> opened = store_.openOrStart(path);
    if (opened) {
        return;
    }
    const Error& error = opened.error();
    if (error.code == ErrorCode::Cancelled) {
        refusesToReplace();
    } else if (error.code == ErrorCode::FileCorrupt) {
        journal_.add(Severity::Error, texts::errorText(error));
        offerRecovery(path, error);
    } else {
        warn(tr("The project could not be opened"), error, QLatin1String(kDamaged));
    }
}

void ProjectFiles::openCopy(const QString& path, const QString& name) {
    if (const Result<void> opened = store_.openCopy(path, name); !opened) {
        warn(tr("The project could not be opened"), opened.error(), QLatin1String(kDamaged));
        return;
    }
    journal_.add(Severity::Info,
                 tr("Opened a copy of “%1”. Save the copy to a file to keep changes.").arg(name));
}

bool ProjectFiles::refusesToReplace() {
    const Result<void> may = store_.mayReplace();
    if (!may) {
        warn(tr("The project could not be opened"), may.error(), QLatin1String(kRefused));
    }
    return !may;
}

void ProjectFiles::endRefusal() {
    Q_EMIT noticeResolved(QLatin1String(kRefused));
    if (std::exchange(isAnswerPostponed_, false) && store_.obstacle() != ProjectStore::Obstacle::None) {
        askAboutFile();
    }
    store_.checkFile();  // another window may have saved the file while no question could be shown
}

bool ProjectFiles::mayReplace(QWidget* over) {
    return !refusesToReplace() && mayLeave(over);
}

bool ProjectFiles::mayLeave(QWidget* over) {
    if (!store_.isModified()) {
        return true;
    }
    const bool hasFile = !store_.path().isEmpty();
    const Result<void> saved = hasFile ? store_.saveNow() : Result<void>();
    if (hasFile && saved) {
        return true;
    }
    const QString why =
        !store_.copyName().isEmpty() ? tr("“%1” is a copy with unsaved changes.").arg(store_.copyName())
        : hasFile ? tr("%1 has unsaved changes. %2").arg(store_.name(), texts::errorText(saved.error()))
                  : tr("The project has unsaved changes.");
    QMessageBox question(QMessageBox::Question, tr("Save project"), why, QMessageBox::NoButton, over);
    question.setObjectName(QStringLiteral("unsavedCopy"));
    QPushButton* save = question.addButton(tr("Save as…"), QMessageBox::AcceptRole);
    save->setObjectName(QStringLiteral("unsavedCopy.save"));
    QPushButton* drop = question.addButton(tr("Discard changes"), QMessageBox::DestructiveRole);
    drop->setObjectName(QStringLiteral("unsavedCopy.drop"));
    QPushButton* stay = question.addButton(tr("Cancel"), QMessageBox::RejectRole);
    stay->setObjectName(QStringLiteral("unsavedCopy.stay"));
    question.setDefaultButton(save);
    question.setEscapeButton(stay);
    question.exec();
    if (question.clickedButton() == save) {
        askToSave(over);
        return !store_.isModified();
    }
    if (question.clickedButton() == drop) {
        store_.discardChanges();
        return true;
    }
    return false;
}

void ProjectFiles::offerRecovery(const QString& path, const Error& error) {
    const QString title = tr("%1 is damaged").arg(QFileInfo(path).fileName());
    const Result<project::RecoveredProject> found = project::recoverProject(path);
    if (!found || found->document.waypoints.isEmpty()) {
        Q_EMIT noticeWanted(
            {.title = title, .text = texts::errorText(error), .cause = QLatin1String(kDamaged)});
        return;
    }
    const int whole = found->document.waypoints.size();
    QString text = tr("%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.")
                       .arg(error.context)
                       .arg(whole)
                       .arg(found->lostWaypoints);
    if (found->lostObstacles > 0) {
        text += QLatin1Char(' ') + tr("Unreadable boxes and planes of the cell: %1. Collisions with these "
                                      "objects are not prevented.")
                                       .arg(found->lostObstacles);
    }
    Q_EMIT noticeWanted({.title = title,
                         .text = text,
                         .accept = tr("Open %n waypoints", nullptr, whole),
                         .accepted =
                             [this, path] {
                                 // The user may have changed the current project since the damage was
                                 // detected.
                                 if (!mayReplace(QApplication::activeWindow())) {
                                     return;
                                 }
                                 if (const auto recovered = store_.openRecovered(path); !recovered) {
                                     warn(tr("The project could not be opened"), recovered.error(),
                                          QLatin1String(kDamaged));
                                 }
                             },
                         .cause = QLatin1String(kDamaged)});
}

void ProjectFiles::saveAs(const QString& path) {
    if (const Result<void> saved = store_.saveAs(withSuffix(path)); !saved) {
        warn(tr("The project could not be saved"), saved.error(), QLatin1String(kSaving));
    }
}

}  // namespace tiller

#include "moc_project_files.cpp"
