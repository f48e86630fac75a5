// SPDX-License-Identifier: MIT
#pragma once

// A value or an error. Accessing the value of a failed result is a broken precondition.

#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "robot/core/error.h"

namespace tiller {

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit by intent
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit by intent

    bool ok() const { return content_.index() == 0; }  ///< True if there is a value.
    explicit operator bool() const { return ok(); }

    /// Errors   std::logic_error on a failed result
    const T& value() const& { return checked(), std::get<0>(content_); }
    T& value() & {
        return checked(), std::get<0>(content_);
    }  ///< Errors   std::logic_error on a failed result
    /// Errors   std::logic_error on a failed result. Moves the value out.
    T&& value() && { return checked(), std::get<0>(std::move(content_)); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    /// The error; code None for a successful result.
    Error error() const { return ok() ? Error{} : std::get<1>(content_); }

private:
    void checked() const {
        if (!ok()) {
            throw std::logic_error(
                ("value() of a failed Result: " + std::get<1>(content_).toString()).toStdString());
        }
    }
    std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit by intent

    bool ok() const { return !error_.has_value(); }  ///< True if there is no error.
    explicit operator bool() const { return ok(); }
    /// Throws std::logic_error on a failed result, for callers that rule out an error.
    void value() const {
        if (!ok()) {
            throw std::logic_error("value() of a failed Result: " + error_->message());
        }
    }
    Error error() const {
        return error_.value_or(Error{});
    }  ///< The error; code None for a successful result.

private:
    std::optional<Error> error_;
};

}  // namespace tiller
