#pragma once

#include "devo_evo/experiment/parameters.h"

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

namespace devo_evo
{
/// The parameters that the parameter server holds in a namespace. One of them, `config`, names a YAML file; what it
/// holds goes before the defaults, and the other parameters, which may be typed or text, go before it. (The file is not
/// left to roslaunch, which cannot pass on numbers beyond 32 bits and accepts repeated keys.)
/// @param name_space resolved: "/devo_evo/evolver".
/// @throw InvalidInput naming key, value and what is allowed, for an unknown key, a wrong type or a value out of range,
/// with
///        line if in the file. std::runtime_error if there is no master.
/// @param defaults of what is given neither there nor in the file.
Parameters readParameters(const std::string& name_space, const Parameters& defaults = Parameters());

/// The same from a value that was read already: a struct of parameters. @param source for messages.
Parameters parametersFrom(const XmlRpc::XmlRpcValue& value, const std::string& source,
                          const Parameters& defaults = Parameters());
}  // namespace devo_evo
