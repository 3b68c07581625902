using System.Text;
using Msisf.Adapters.Camera;
using Msisf.Adapters.CameraImport;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.CameraImport;

/// <summary>Camera files of other programs: where a point is seen by the formula that the other program prints.</summary>
public sealed class CameraFormatsTests
{
    /// <summary>px: the lens is inverted to 1e-14 of the image's size.</summary>
    private const double OfLens = 1e-9;

    private static readonly double[] Lens = [-0.2, 0.05, 0.001, -0.002, 0.01, 0.003, -0.004, 0.002, 1e-3, -2e-3, 3e-3, 1e-4];

    /// <summary>Points of the ideal image plane: off the centre, in all quarters.</summary>
    private static readonly (double X, double Y)[] Points = [(0.0, 0.0), (0.21, 0.13), (-0.3, 0.2), (0.25, -0.22), (-0.11, -0.29)];

    /// <summary>A calibration as calibration.cpp, stereo_calib.cpp (M1, no size), Metashape's export and JSON storage write it.</summary>
    [Theory]
    [InlineData("%YAML:1.0\n---\ncalibration_time: \"Sat 28 Nov\"\nimage_width: 64\nimage_height: 48\nflags: 0\n"
            + "{K:camera_matrix}{D:distortion_coefficients}")]
    [InlineData("%YAML:1.0\nimage_Width: 64\nimage_Height: 48\n{K:Camera_Matrix}{D:Distortion_Coefficients}")]
    [InlineData("%YAML:1.0\n---\n{K:M1}{D:D1}")]
    [InlineData("<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>64</image_width>\n"
            + "<image_height>48</image_height>\n{XK}{XD}</opencv_storage>\n")]
    [InlineData("{\"image_width\":64,\"image_height\":48,{JK},{JD}}")]
    public void Read_OpenCv_ProjectsAsItsFormula(string form)
    {
        string k = "70., 0., 31.5, 0., 71., 23.5, 0., 0., 1.";
        string d = string.Join(", ", Lens.Select(Text));
        string text = form;
        foreach (string name in (string[])["camera_matrix", "Camera_Matrix", "M1"])
        {
            text = text.Replace($"{{K:{name}}}",
                $"{name}: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ {k} ]\n", StringComparison.Ordinal);
        }

        foreach (string name in (string[])["distortion_coefficients", "Distortion_Coefficients", "D1"])
        {
            text = text.Replace($"{{D:{name}}}",
                $"{name}: !!opencv-matrix\n   rows: 12\n   cols: 1\n   dt: d\n   data: [ {d} ]\n", StringComparison.Ordinal);
        }

        const string type = "type_id=\"opencv-matrix\"";
        string ofK = k.Replace(",", string.Empty, StringComparison.Ordinal);
        string ofD = d.Replace(",", string.Empty, StringComparison.Ordinal);
        text = text.Replace(
                "{XK}", $"<camera_matrix {type}><rows>3</rows><cols>3</cols><dt>d</dt><data>\n {ofK}</data></camera_matrix>\n",
                StringComparison.Ordinal)
            .Replace(
                "{XD}", $"<distortion_coefficients {type}><rows>12</rows><cols>1</cols><dt>d</dt><data>{ofD}</data>"
                    + "</distortion_coefficients>", StringComparison.Ordinal)
            .Replace("{JK}", $"\"camera_matrix\":{{\"type_id\":\"opencv-matrix\",\"rows\":3,\"cols\":3,\"dt\":\"d\",\"data\":[70."
                    + $"0,0.0,31.5,0.0,71.0,23.5,0.0,0.0,1.0]}}", StringComparison.Ordinal)
            .Replace("{JD}", $"\"distortion_coefficients\":{{\"type_id\":\"opencv-matrix\",\"rows\":12,\"cols\":1,\"dt\":\"d\",\""
                    + $"data\":[{d}]}}", StringComparison.Ordinal);

        CameraModel model = Read(text, size: (64, 48));

        Assert.Equal((64, 48), (model.Width, model.Height));
        RequireProjection(model, first: 0.0, (x, y) => Pixel(OpenCv(x, y, Lens), 70.0, 71.0, 31.5, 23.5));
    }

    /// <summary>
    /// The same camera in the files of other programs: each with its own place of the first pixel's centre, and with the lens that it
    /// has. Not the files of the reports, but others of the same kind.
    /// </summary>
    [Theory]
    [InlineData("image_width: 64\nimage_height: 48\ncamera_name: n\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
            + "  data: [70, 0, 31.5, 0, 71, 23.5, 0, 0, 1]\ndistortion_model: rational_polynomial\n"
            + "distortion_coefficients:\n  rows: 1\n  cols: 8\n"
            + "  data: [-0.2, 0.05, 0.001, -0.002, 0.01, 0.003, -0.004, 0.002]\n", 8)]
    [InlineData("header:\n  seq: 4\n  frame_id: cam\nheight: 48\nwidth: 64\ndistortion_model: plumb_bob\n"
            + "D: [-0.2, 0.05, 0.001, -0.002, 0.01]\nK: [70.0, 0.0, 31.5, 0.0, 71.0, 23.5, 0.0, 0.0, 1.0]\n"
            + "R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\n"
            + "P: [70.0, 0.0, 31.5, 0.0, 0.0, 71.0, 23.5, 0.0, 0.0, 0.0, 1.0, 0.0]\nbinning_x: 0\nbinning_y: 0\nroi:\n"
            + "  x_offset: 0\n  y_offset: 0\n  height: 0\n  width: 0\n  do_rectify: false\n---\n", 5)]
    [InlineData("height: 48\nwidth: 64\ndistortion_model: plumb_bob\nd:\n- -0.2\n- 0.05\n- 0.001\n- -0.002\n- 0.01\nk:\n"
            + "- 70.0\n- 0.0\n- 31.5\n- 0.0\n- 71.0\n- 23.5\n- 0.0\n- 0.0\n- 1.0\n", 5)]
    [InlineData("cam0:\n  T_cam_imu:\n  - [0.0, -1.0, 0.0, 0.0]\n  - [1.0, 0.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n"
            + "  - [0.0, 0.0, 0.0, 1.0]\n  camera_model: pinhole\n  distortion_coeffs: [-0.2, 0.05, 0.001, -0.002]\n"
            + "  distortion_model: radtan\n  intrinsics: [70, 71, 31.5, 23.5]\n  resolution: [64, 48]\n"
            + "  timeshift_cam_imu: 0.01\n", 4)]
    [InlineData("%YAML:1.0\nsensor_type: camera\ncomment: VI-Sensor\nT_BS:\n  cols: 4\n  rows: 4\n"
            + "  data: [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]\nrate_hz: 20\n"
            + "resolution: [64, 48]\ncamera_model: pinhole\nintrinsics: [70, 71, 31.5, 23.5]\n"
            + "distortion_model: radial-tangential\ndistortion_coefficients: [-0.2, 0.05, 0.001, -0.002]\n", 4)]
    [InlineData("%YAML:1.0\n# ORB-SLAM2\nCamera.fx: 70.0\nCamera.fy: 71.0\nCamera.cx: 31.5\nCamera.cy: 23.5\n"
            + "Camera.k1: -0.2\nCamera.k2: 0.05\nCamera.p1: 0.001\nCamera.p2: -0.002\nCamera.width: 64\n"
            + "Camera.height: 48\nCamera.fps: 20.0\nORBextractor.nFeatures: 1000\n", 4)]
    [InlineData("# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n"
            + "# Number of cameras: 1\n3 FULL_OPENCV 64 48 70 71 32 24 -0.2 0.05 0.001 -0.002 0.01 0.003 -0.004 0.002\n", 8)]
    public void Read_OpenCvsLensInOtherFiles_ProjectsAsItsFormula(string text, int coefficients)
    {
        CameraModel model = Read(text);

        Assert.Equal((64, 48), (model.Width, model.Height));
        double[] lens = [.. Lens.Take(coefficients), .. new double[12 - coefficients]];
        RequireProjection(model, first: 0.0, (x, y) => Pixel(OpenCv(x, y, lens), 70.0, 71.0, 31.5, 23.5));
    }

    /// <summary>Models of one focal length, and the fisheye by its angle: colmap/src/colmap/sensor/models.h, OpenCV's fisheye.</summary>
    [Theory]
    [InlineData("1 SIMPLE_PINHOLE 64 48 70 32 24\n", "none", 70.0)]
    [InlineData("1 PINHOLE 64 48 70 71 32 24\n", "none", 71.0)]
    [InlineData("1 SIMPLE_RADIAL 64 48 70 32 24 -0.2\n", "k1", 70.0)]
    [InlineData("1 RADIAL 64 48 70 32 24 -0.2 0.05\n", "k2", 70.0)]
    [InlineData("1 SIMPLE_RADIAL_FISHEYE 64 48 70 32 24 -0.2\n", "fisheye 1", 70.0)]
    [InlineData("1 RADIAL_FISHEYE 64 48 70 32 24 -0.2 0.05\n", "fisheye 2", 70.0)]
    [InlineData("1 OPENCV_FISHEYE 64 48 70 71 32 24 -0.2 0.05 0.01 -0.003\n", "fisheye 4", 71.0)]
    [InlineData("1 THIN_PRISM_FISHEYE 64 48 70 71 32 24 -0.2 0.05 0 0 0.01 -0.003 0 0\n", "fisheye 4", 71.0)]
    [InlineData("1 FISHEYE 64 48 70 71 32 24\n", "fisheye 0", 71.0)]
    [InlineData("%YAML:1.0\n---\nfisheye_model: 1\nimage_width: 64\nimage_height: 48\ncamera_matrix: !!opencv-matrix\n"
            + "   rows: 3\n   cols: 3\n   dt: d\n   data: [70., 0., 31.5, 0., 71., 23.5, 0., 0., 1.]\n"
            + "distortion_coefficients: !!opencv-matrix\n   rows: 4\n   cols: 1\n   dt: d\n"
            + "   data: [-0.2, 0.05, 0.01, -0.003]\n", "fisheye 4", 71.0)]
    [InlineData("cam0:\n  camera_model: pinhole\n  distortion_coeffs: [-0.2, 0.05, 0.01, -0.003]\n"
            + "  distortion_model: equidistant\n  intrinsics: [70, 71, 31.5, 23.5]\n  resolution: [64, 48]\n", "fisheye 4", 71.0)]
    [InlineData("VERSION_4\nPINHOLE\nfu = 7\nfv = 7.1\ncu = 3.15\ncv = 2.35\nu_direction = 1 0 0\nv_direction = 0 1 0\n"
            + "w_direction = 0 0 1\nC = 1 2 3\nR = 1 0 0 0 1 0 0 0 1\npitch = 0.1\nFISHEYE\nk1 = -0.2\nk2 = 0.05\n"
            + "k3 = 0.01\nk4 = -0.003\n", "fisheye 4", 71.0)]
    public void Read_OtherLenses_ProjectAsTheirFormulas(string text, string lens, double focalDown)
    {
        double[] k = [-0.2, 0.05, 0.01, -0.003];
        CameraModel model = Read(text, size: (64, 48));

        RequireProjection(model, first: 0.0, (x, y) =>
        {
            double r = Math.Sqrt((x * x) + (y * y));
            double t = Math.Atan(r);
            double factor = lens switch
            {
                "none" => 1.0,
                "k1" => 1.0 + (k[0] * r * r),
                "k2" => 1.0 + (k[0] * r * r) + (k[1] * r * r * r * r),
                _ when r == 0.0 => 1.0,
                _ => t * (1.0 + k.Take(lens[^1] - '0').Select((c, i) => c * Math.Pow(t, 2 * (i + 1))).Sum()) / r,
            };
            return Pixel((factor * x, factor * y), 70.0, focalDown, 31.5, 23.5);
        });
    }

    /// <summary>ALE's cameras of real images: focal length and centre are those of the file, as its own keywords say them.</summary>
    [RequiresFact(Part.LroNac)]
    public void Read_AlesCameraOfLroNac_IsThatOfItsKeywords()
    {
        CameraFile file = CameraFileReader.Read(LroNac.Isd);

        // focal2pixel_samples (0, 0, 142.857), focal2pixel_lines (0, -142.857, 0): the detector's y is the row. The centre is 2547.5
        // where the first pixel's is 0.5; u_y = d_y / (1 + 1.81e-5 d_y^2), mm.
        Assert.Equal((5064, 1), (file.Model.Width, file.Model.Height));
        Assert.Equal((ScanKind.LineScan, 0.0010334295999999998), (file.Scan!.Kind, file.Scan.Period));
        foreach (double sample in (double[])[0.5, 1000.5, 2547.5, 5063.5])
        {
            double distorted = (sample - 2547.5) / 142.857;
            double ideal = distorted / (1.0 + (1.81e-5 * distorted * distorted)) / 699.62;
            Assert.Equal(ideal, file.Model.ToIdeal(sample + 0.5, 1.0).Right, 1e-15);
        }
    }

    /// <summary>
    /// ALE's camera of a Kaguya TC image: x is down and y is left on its detector, whose first line is 1 px from the boresight's.
    /// </summary>
    [RequiresFact(Part.LroNac)]
    public void Read_AlesCameraOfKaguya_FollowsUsgscsmsFormula()
    {
        CameraFile file = CameraFileReader.Read(Path.Combine(Path.GetDirectoryName(LroNac.Isd)!, "kaguyatc_isd.json"));

        foreach (double sample in (double[])[0.5, 700.5, 1604.0, 3207.5])
        {
            double y = (sample + 0.5 - 2047.5) / -142.85714285714286;
            double x = 1.0 / 142.85714285714286;
            double r = Math.Sqrt((x * x) + (y * y));
            double ux = x - 0.0725 - 0.0009649900000000001 + (0.00098441 * r) + (8.5773e-06 * r * r) - (3.7438e-06 * r * r * r);
            double uy = y + 0.0214 - 0.0013796 + (1.3502e-05 * r) + (2.7251e-06 * r * r) - (6.193800000000001e-06 * r * r * r);
            (double right, double down) = file.Model.ToIdeal(sample + 0.5, 1.0);
            Assert.Equal(-uy / 72.45, right, 1e-13);
            Assert.Equal(ux / 72.45, down, 1e-13);
        }
    }

    /// <summary>A lens of OpenCV on a detector that is turned by a quarter: x of the state is down, y is left.</summary>
    [Fact]
    public void Read_TurnedRadtan_ProjectsAsUsgscsm()
    {
        double[] lens = [-0.2, 0.05, 0.01, -0.02, 0.03];
        string text = "USGS_ASTRO_FRAME_SENSOR_MODEL\n{\"m_modelName\":\"USGS_ASTRO_FRAME_SENSOR_MODEL\",\"m_nLines\":48,\"m_nSamples\":64,"
            + "\"m_focalLength\":0.7,\"m_iTransS\":[0.0,0.0,-100.0],\"m_iTransL\":[0.0,100.0,0.0],\"m_ccdCenter\":[20.0,35.0],"
            + "\"m_startingDetectorSample\":0.0,\"m_startingDetectorLine\":0.0,\"m_detectorSampleSumming\":1,"
            + "\"m_detectorLineSumming\":1,\"m_distortionType\":7,\"m_opticalDistCoeffs\":["
            + string.Join(", ", lens.Select(Text)) + "]}";
        CameraModel model = Read(text);

        foreach ((double x, double y) in Points)
        {
            (double dx, double dy) = OpenCv(x, y, [.. lens, .. new double[7]]);
            Assert.True(model.TryToImage(-y, x, out RenderingPoint found));
            Assert.Equal((-100.0 * 0.7 * dy) + 35.0, found.X - 0.5, OfLens);
            Assert.Equal((100.0 * 0.7 * dx) + 20.0, found.Y - 0.5, OfLens);
        }
    }

    /// <summary>Each file that is read in the error of a lens, a model or a part that has no counterpart, by its place.</summary>
    [Theory]
    [InlineData("1 FOV 64 48 70 71 32 24 0.9\n",
        "camera.txt, line 1: the camera model 'FOV' has no counterpart in msis. Read are SIMPLE_PINHOLE")]
    [InlineData("1 OPENCV 64 48 70 71 32 24 -0.2\n", "camera.txt, line 1: OPENCV has 8 parameters, and 5 are there.")]
    [InlineData("1 THIN_PRISM_FISHEYE 64 48 70 71 32 24 0 0 1e-3 0 0 0 0 0\n",
        "camera.txt, line 1: THIN_PRISM_FISHEYE with p1, p2, sx1 or sy1")]
    [InlineData("cam0:\n  camera_model: omni\n  intrinsics: [1, 70, 71, 31, 23]\n  resolution: [64, 48]\n",
        "camera.txt, line 2, column 3: the camera model 'omni' has no counterpart")]
    [InlineData("cam0:\n  camera_model: pinhole\n  distortion_model: fov\n  distortion_coeffs: [0.9]\n"
            + "  intrinsics: [70, 71, 31, 23]\n  resolution: [64, 48]\n",
        "camera.txt, line 3, column 3: the lens 'fov' has no counterpart")]
    [InlineData("height: 48\nwidth: 64\ndistortion_model: none\nD: [-0.1, 0, 0, 0, 0]\nK: [70, 0, 31, 0, 71, 23, 0, 0, 1]\n",
        "camera.txt, line 4, column 1: the lens is 'none', but 'D' are not 0. Name the lens, or make them 0")]
    [InlineData("height: 48\nwidth: 64\nbinning_x: 2\nD: []\nK: [70, 0, 31, 0, 71, 23, 0, 0, 1]\n",
        "camera.txt, line 3, column 1: 'binning_x' above 1")]
    [InlineData("height: 48\nwidth: 64\nD: []\nK: [70, 2, 31, 0, 71, 23, 0, 0, 1]\n",
        "camera.txt, line 4, column 1: 'K' has a skew of 2 px, which ROS leaves out")]
    [InlineData("%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
            + "   data: [70., 0., 31.5, 0., 71., 23.5, 0., 0., 1.]\n", "camera.txt, line 1, column 1: a camera needs 'width'")]
    [InlineData("VERSION_4\nPINHOLE\nfu = 7\nfv = 7\ncu = 3\ncv = 2\nu_direction = -1 0 0\npitch = 0.1\nNULL\n",
        "camera.txt, line 7: u_direction is not 1 0 0")]
    [InlineData("VERSION_4\nPINHOLE\nfu = 7\nfv = 7\ncu = 3\ncv = 2\npitch = 0.1\nPHOTOMETRIX\n",
        "camera.txt, line 8: the lens 'PHOTOMETRIX' has no counterpart")]
    [InlineData("USGS_ASTRO_SAR_SENSOR_MODEL\n{\"m_modelName\":\"USGS_ASTRO_SAR_SENSOR_MODEL\"}\n",
        "camera.txt: the sensor model 'USGS_ASTRO_SAR_SENSOR_MODEL' is not read")]
    [InlineData("1 PINHOLE 64 48 70 71 32 24\n2 PINHOLE 64 48 80 81 32 24\n",
        "camera.txt: this file of COLMAP has several cameras: 1, 2. Choose one: --camera 'camera.txt,camera=1'.")]
    public void Read_WithoutCounterpart_IsRefusedByName(string text, string beginning) => Assert.StartsWith(
        beginning, Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);

    /// <summary>The advice of the refusal of a file with several cameras, followed.</summary>
    [Fact]
    public void Read_ChosenCamera_IsThatOne()
    {
        const string text = "cam0:\n  camera_model: pinhole\n  intrinsics: [70, 71, 31, 23]\n  resolution: [64, 48]\n"
            + "cam1:\n  camera_model: pinhole\n  intrinsics: [80, 81, 30, 22]\n  resolution: [60, 40]\n";
        string advice = Assert.Throws<BadInputException>(() => Read(text)).Message;
        string given = advice.Split('\'')[1].Replace("cam0", "cam1", StringComparison.Ordinal);

        CameraModel model = CameraFileReader.Parse(Encoding.UTF8.GetBytes(text), given).Model;

        Assert.Equal((60, 40, 80.0, 81.0), (model.Width, model.Height, model.FocalX, model.FocalY));
        Assert.Equal((31.0, 23.0), (model.PrincipalX, model.PrincipalY));
        Assert.Equal("cam0, cam1", Assert.Throws<BadInputException>(
            () => CameraFileReader.Parse(Encoding.UTF8.GetBytes(text), "camera.txt,camera=cam7")).Message
            .Split("there are ")[1].TrimEnd('.'));
    }

    /// <summary>Files of formats that are known, but have no camera that is read.</summary>
    [Theory]
    [InlineData("<?xml version=\"1.0\"?>\n<document version=\"1.2.0\">\n  <chunk>", "a file of Agisoft Metashape", "OpenCV XML")]
    [InlineData("# Bundle file v0.3\n2 100\n", "a file of Bundler", "cameras.txt")]
    [InlineData("{\"sfm_data_version\": \"0.3\"}", "a file of OpenMVG", "openMVG2Colmap")]
    [InlineData("{\n \"camera_angle_x\": 0.7,\n \"frames\": []}", "a file of transforms of NeRF", "cameras.txt")]
    [InlineData("BLENDER-v300REND", "a file of Blender", "pixel-pitch")]
    [InlineData("MATLAB 5.0 MAT-file, Platform: GLNXA64", "a file of MATLAB", "cameras.txt")]
    [InlineData("DAF/SPK ", "an SPK kernel of SPICE", "--spk")]
    [InlineData("KPL/IK\n", "a text kernel of SPICE", "--kernels")]
    [InlineData("PDS_VERSION_ID = PDS3\n", "a PDS3 label", "msis twin")]
    public void Read_KnownFormat_IsNamedWithWhatToDo(string text, string name, string advice)
    {
        string message = Assert.Throws<BadInputException>(() => Read(text)).Message;

        Assert.StartsWith($"camera.txt: this is {name}, which is not read here. ", message, StringComparison.Ordinal);
        Assert.Contains(advice, message, StringComparison.Ordinal);
    }

    private static CameraModel Read(string text, (int? Width, int? Height) size = default) =>
        CameraFileReader.Parse(Encoding.UTF8.GetBytes(text), "camera.txt", size: size).Model;

    /// <summary>OpenCV 4, Camera Calibration and 3D Reconstruction, "Detailed Description".</summary>
    private static (double X, double Y) OpenCv(double x, double y, double[] d)
    {
        double r2 = (x * x) + (y * y);
        double radial = (1.0 + (d[0] * r2) + (d[1] * r2 * r2) + (d[4] * r2 * r2 * r2))
            / (1.0 + (d[5] * r2) + (d[6] * r2 * r2) + (d[7] * r2 * r2 * r2));
        return (
            (x * radial) + (2.0 * d[2] * x * y) + (d[3] * (r2 + (2.0 * x * x))) + (d[8] * r2) + (d[9] * r2 * r2),
            (y * radial) + (d[2] * (r2 + (2.0 * y * y))) + (2.0 * d[3] * x * y) + (d[10] * r2) + (d[11] * r2 * r2));
    }

    private static (double U, double V) Pixel((double X, double Y) point, double fx, double fy, double cx, double cy) =>
        ((fx * point.X) + cx, (fy * point.Y) + cy);

    private static void RequireProjection(CameraModel model, double first, Func<double, double, (double U, double V)> expected)
    {
        foreach ((double x, double y) in Points)
        {
            Assert.True(model.TryToImage(x, y, out RenderingPoint found));
            (double u, double v) = expected(x, y);
            Assert.Equal(u, found.X - 1.0 + first, OfLens); // ours count from 1
            Assert.Equal(v, found.Y - 1.0 + first, OfLens);
        }
    }

    private static string Text(double number) => number.ToString("R", System.Globalization.CultureInfo.InvariantCulture);
}
