// SPDX-License-Identifier: MIT
#include "robot/recording/hdf5/detail/hdf5_notes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "robot/recording/detail/csv_notes.h"

namespace tiller::recording::hdf5 {

namespace {

constexpr const char* kGroup = "notes";
constexpr const char* kTime = "notes/time";
constexpr const char* kLevel = "notes/level";
constexpr const char* kSource = "notes/source";
constexpr const char* kText = "notes/text";
constexpr const char* kMeaning = "notes, warnings and errors of the recording";
// Limits of files that can be read.
constexpr std::size_t kMaxNotes = 1'000'000;
constexpr std::size_t kMaxTextBytes = 64u << 20;

bool put(hid_t file, const char* name, hid_t stored, hid_t given, std::size_t count, const void* values) {
    const hsize_t extent = count;
    const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
    Handle set(H5Dcreate2(file, name, stored, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    const bool isWritten = set && H5Dwrite(set.get(), given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0;
    return set.reset() && isWritten;
}

bool putTexts(hid_t file, const char* name, const std::vector<std::string>& texts) {
    std::size_t length = 1;
    for (const std::string& text : texts) {
        length = std::max(length, text.size());
    }
    std::string bytes;
    for (const std::string& text : texts) {
        bytes += text;
        bytes.append(length - text.size(), '\0');
    }
    const Handle type = textType(length);
    return put(file, name, type.get(), type.get(), texts.size(), bytes.data());
}

/// A data set with one value per note; an invalid handle if it has a different layout.
Handle openColumn(hid_t file, const char* name, H5T_class_t kind, std::size_t count) {
    Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const Handle type(set ? H5Dget_type(set.get()) : -1, H5Tclose);
    const Handle space(set ? H5Dget_space(set.get()) : -1, H5Sclose);
    const bool fits = type && space && H5Tget_class(type.get()) == kind &&
                      H5Sget_simple_extent_ndims(space.get()) == 1 &&
                      H5Sget_simple_extent_npoints(space.get()) == static_cast<hssize_t>(count);
    return fits ? std::move(set) : Handle();
}

std::vector<double> takeNumbers(hid_t file, const char* name, H5T_class_t kind, std::size_t count) {
    const Handle set = openColumn(file, name, kind, count);
    std::vector<double> values(count);
    const bool isRead =
        set && H5Dread(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
    return isRead ? values : std::vector<double>();
}

std::vector<QString> takeTexts(hid_t file, const char* name, std::size_t count) {
    const Handle set = openColumn(file, name, H5T_STRING, count);
    const Handle type(set ? H5Dget_type(set.get()) : -1, H5Tclose);
    const std::size_t length = type && H5Tis_variable_str(type.get()) == 0 ? H5Tget_size(type.get()) : 0;
    if (length == 0 || length > kMaxTextBytes / count) {
        return {};
    }
    std::string bytes(length * count, '\0');
    if (H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) {
        return {};
    }
    std::vector<QString> texts;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view text = std::string_view(bytes).substr(i * length, length);
        const std::string_view used = text.substr(0, text.find('\0'));
        texts.push_back(QString::fromUtf8(used.data(), static_cast<qsizetype>(used.size())));
    }
    return texts;
}

}  // namespace

bool writeNotes(hid_t file, const std::vector<ExportedEvent>& events) {
    std::vector<double> times;
    std::vector<int> levels;
    std::vector<std::string> sources;
    std::vector<std::string> texts;
    for (const auto& [row, event] : events) {
        if (isCsvNote(event.level, event.source)) {
            times.push_back(event.seconds);
            levels.push_back(event.level);
            sources.push_back(event.source.toStdString());
            texts.push_back(event.text.toStdString());
        }
    }
    if (times.empty()) {
        return true;
    }
    const Handle group(H5Gcreate2(file, kGroup, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    return group && putText(group.get(), "meaning", kMeaning) &&
           put(file, kTime, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, times.size(), times.data()) &&
           put(file, kLevel, H5T_STD_I32LE, H5T_NATIVE_INT, levels.size(), levels.data()) &&
           putTexts(file, kSource, sources) && putTexts(file, kText, texts);
}

bool hasNotes(hid_t file) {
    const Handle group(H5Lexists(file, kGroup, H5P_DEFAULT) > 0 ? H5Gopen2(file, kGroup, H5P_DEFAULT) : -1,
                       H5Gclose);
    return group && takeText(group.get(), "meaning") == kMeaning;
}

bool isOfNotes(std::string_view name) {
    return name == kGroup || name.starts_with(std::string(kGroup) + '/');
}

std::vector<RecordedEvent> readNotes(hid_t file) {
    const Handle set(H5Dopen2(file, kTime, H5P_DEFAULT), H5Dclose);
    const Handle space(set ? H5Dget_space(set.get()) : -1, H5Sclose);
    const hssize_t points = space ? H5Sget_simple_extent_npoints(space.get()) : 0;
    if (points <= 0 || points > static_cast<hssize_t>(kMaxNotes)) {
        return {};
    }
    const auto count = static_cast<std::size_t>(points);
    const std::vector<double> times = takeNumbers(file, kTime, H5T_FLOAT, count);
    const std::vector<double> levels = takeNumbers(file, kLevel, H5T_INTEGER, count);
    const std::vector<QString> sources = takeTexts(file, kSource, count);
    const std::vector<QString> texts = takeTexts(file, kText, count);
    std::vector<RecordedEvent> notes;
    if (times.empty() || levels.empty() || sources.empty() || texts.empty()) {
        return notes;
    }
    for (std::size_t i = 0; i < count; ++i) {
        constexpr double kMaxLevel = 100;
        if (std::isfinite(times[i]) && levels[i] >= 0 && levels[i] <= kMaxLevel) {
            notes.push_back({times[i], static_cast<int>(levels[i]), sources[i], texts[i]});
        }
    }
    return notes;
}

}  // namespace tiller::recording::hdf5
