#pragma once

#include <ros/advertise_service_options.h>
#include <ros/message_traits.h>
#include <ros/node_handle.h>
#include <ros/serialization.h>
#include <ros/service_callback_helper.h>
#include <ros/service_traits.h>

#include <boost/make_shared.hpp>

#include <functional>
#include <string>
#include <utility>

namespace devo_evo
{
/// Answers a request that is given as it was received, to be read by readMessage(). @param caller name of its node.
/// @return whether there is an answer.
template <class Service>
using CheckedServiceCallback = std::function<bool(const ros::SerializedMessage& request, const std::string& caller,
                                                  typename Service::Response& response)>;

/// Offers a service as node.advertiseService() does, except that roscpp does not read requests.
template <class Service>
ros::ServiceServer advertiseCheckedService(ros::NodeHandle& node, const std::string& name,
                                           CheckedServiceCallback<Service> callback)
{
  class Helper : public ros::ServiceCallbackHelper
  {
  public:
    explicit Helper(CheckedServiceCallback<Service> callback) : callback_(std::move(callback)) {}

    bool call(ros::ServiceCallbackHelperCallParams& call) override
    {
      typename Service::Response response;
      const bool answered = callback_(call.request, (*call.connection_header)["callerid"], response);
      call.response = ros::serialization::serializeServiceResponse(answered, response);
      return answered;
    }

  private:
    const CheckedServiceCallback<Service> callback_;
  };

  ros::AdvertiseServiceOptions options;
  options.service = name;
  options.md5sum = ros::service_traits::md5sum<Service>();
  options.datatype = ros::service_traits::datatype<Service>();
  options.req_datatype = ros::message_traits::datatype<typename Service::Request>();
  options.res_datatype = ros::message_traits::datatype<typename Service::Response>();
  options.helper = boost::make_shared<Helper>(std::move(callback));
  return node.advertiseService(options);
}
}  // namespace devo_evo
