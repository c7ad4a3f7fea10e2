"""Reads a flight bag with ROS's own reader and compares it with the other files of the flight directory, digit by digit.

Prints the time in nanoseconds and the SHA-256 of the pixels of each image.
"""

import csv
import hashlib
import pathlib
import sys

import rosbag
import yaml

EPOCH_NS = 1_000_000_000_000
FLIGHT = pathlib.Path(sys.argv[1])
RECORDING = FLIGHT / "recording"


def require_equal(what, got, expected):
    if got == expected:
        return
    if isinstance(got, list) and len(got) == len(expected):
        index, got, expected = next((i, a, b) for i, (a, b) in enumerate(zip(got, expected)) if a != b)
        what = f"{what} at {index}"
    sys.exit(f"{what}: got {str(got)[:500]}, expected {str(expected)[:500]}")


def time_ns(stamp):
    return stamp.to_nsec() - EPOCH_NS


def values(message, fields):
    return [getattr(message, field) for field in fields]


def pose_row(stamp, position, orientation):
    return [time_ns(stamp), *values(position, "xyz"), *values(orientation, "xyzw")]


def tum_rows(name):
    rows = []
    for line in (FLIGHT / name).read_text().splitlines()[1:]:
        time_s, *numbers = map(float, line.split())
        rows.append([round(time_s * 1e9), *numbers])
    return rows


def check_poses(messages):
    poses = {
        "/truth": ("truth.tum", lambda m: m.pose),
        "/tracking": ("tracking.tum", lambda m: m.pose),
        "/estimate": ("estimate.tum", lambda m: m.pose.pose),
    }
    for topic, (name, pose_of) in poses.items():
        rows = []
        for message in messages[topic]:
            require_equal(topic, message.header.frame_id, "world")
            pose = pose_of(message)
            rows.append(pose_row(message.header.stamp, pose.position, pose.orientation))
        require_equal(topic, rows, tum_rows(name))
        if len(rows) < 100:
            sys.exit(f"{topic} has only {len(rows)} poses")


def check_covariances(messages):
    axes = ["x", "y", "z", "rx", "ry", "rz"]
    upper = [(i, j) for i in range(6) for j in range(i, 6)]
    with open(FLIGHT / "frames.csv") as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "ok"]
    expected = [[float(row[f"cov_{axes[i]}_{axes[j]}"]) for i, j in upper] for row in rows]
    got = [[message.pose.covariance[6 * i + j] for i, j in upper] for message in messages["/estimate"]]
    require_equal("covariances", got, expected)


def check_transforms(messages):
    rows = []
    for message in messages["/tf"]:
        (transform,) = message.transforms
        require_equal("/tf", (transform.header.frame_id, transform.child_frame_id), ("world", "base_link"))
        part = transform.transform
        rows.append(pose_row(transform.header.stamp, part.translation, part.rotation))
    require_equal("/tf", rows, tum_rows("truth.tum"))

    (mounting,) = messages["/tf_static"]
    for transform, sensor in zip(mounting.transforms, ("cam0", "imu0"), strict=True):
        frames = (transform.header.frame_id, transform.child_frame_id)
        require_equal("/tf_static", frames, ("base_link", {"cam0": "camera", "imu0": "imu"}[sensor]))
        matrix = yaml.safe_load((RECORDING / "mav0" / sensor / "sensor.yaml").read_text())["T_BS"]["data"]
        require_equal(sensor, values(transform.transform.translation, "xyz"), [matrix[3], matrix[7], matrix[11]])
        x, y, z, w = values(transform.transform.rotation, "xyzw")
        rotation = [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                    2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]
        expected = [matrix[4 * row + column] for row in range(3) for column in range(3)]
        if max(abs(a - b) for a, b in zip(rotation, expected)) > 1e-12:
            sys.exit(f"/tf_static: {sensor} has rotation {rotation} instead of {expected}")


def check_imu(messages):
    rows = []
    for message in messages["/imu/data_raw"]:
        require_equal("imu", (message.header.frame_id, message.orientation_covariance[0]), ("imu", -1))
        rows.append([time_ns(message.header.stamp), *values(message.angular_velocity, "xyz"),
                     *values(message.linear_acceleration, "xyz")])
    lines = (RECORDING / "mav0/imu0/data.csv").read_text().splitlines()[1:]
    cells = [line.split(",") for line in lines]
    require_equal("imu", rows, [[int(row[0]), *map(float, row[1:])] for row in cells])


def check_camera(messages):
    camera = yaml.safe_load((RECORDING / "camera.yaml").read_text())
    images = messages["/camera/image_raw"]
    require_equal("times of camera_info", [m.header.stamp for m in messages["/camera/camera_info"]],
                  [m.header.stamp for m in images])
    for info in messages["/camera/camera_info"]:
        require_equal("K", list(info.K), camera["camera_matrix"]["data"])
        require_equal("D", list(info.D), camera["distortion_coefficients"]["data"])
        require_equal("R", list(info.R), camera["rectification_matrix"]["data"])
        require_equal("P", list(info.P), camera["projection_matrix"]["data"])
        size = (camera["image_width"], camera["image_height"], camera["distortion_model"])
        require_equal("camera", (info.width, info.height, info.distortion_model), size)
    for image in images:
        require_equal("layout", (image.encoding, image.step, image.header.frame_id), ("mono8", image.width, "camera"))
        print(time_ns(image.header.stamp), hashlib.sha256(image.data).hexdigest())


def main():
    messages, recorded = {}, []
    with rosbag.Bag(str(FLIGHT / "flight.bag")) as bag:
        for topic, message, time in bag.read_messages():
            messages.setdefault(topic, []).append(message)
            recorded.append(time)
            if hasattr(message, "header") and message.header.stamp > time:
                sys.exit(f"{topic}: recording time is before the stamp")
    require_equal("order", recorded, sorted(recorded))
    (scenario,) = messages["/touchdown/scenario"]
    require_equal("scenario", scenario.data, (FLIGHT / "scenario.yaml").read_text())
    check_poses(messages)
    check_covariances(messages)
    check_transforms(messages)
    check_imu(messages)
    check_camera(messages)


main()
