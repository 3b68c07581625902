using Msisf.Adapters.Input;

namespace Msisf.Adapters.CameraImport;

/// <summary>What the calibrations of OpenCV, ROS, Kalibr, EuRoC and ORB-SLAM have in common.</summary>
/// <param name="Program">Whose file it is.</param>
/// <param name="Path">For messages.</param>
/// <param name="Root">The node of the camera.</param>
internal sealed record CalibrationTree(string Program, string Path, FileTree Root)
{
    /// <summary>px; null if the file has neither of the names.</summary>
    public (int Width, int Height)? Size()
    {
        if (Root.Find("resolution", "imagesize", "size") is { } pair)
        {
            double[] numbers = NumbersOf(pair, 2, 2);
            return (Whole(pair, numbers[0]), Whole(pair, numbers[1]));
        }

        FileTree? width = Root.Find("imagewidth", "width", "camerawidth", "camera1width");
        FileTree? height = Root.Find("imageheight", "height", "cameraheight", "camera1height");
        return width is null || height is null ? null
            : (Whole(width, NumbersOf(width, 1, 1)[0]), Whole(height, NumbersOf(height, 1, 1)[0]));
    }

    /// <summary>A camera by its matrix of 3 x 3.</summary>
    public ImportedCamera OfMatrix(FileTree matrix)
    {
        double[] k = MatrixOf(matrix);
        if (k.Length != 9 || k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0)
        {
            throw Wrong(matrix, $"'{matrix.Name}' is not a camera matrix, 3 x 3 numbers: fx, 0, cx, 0, fy, cy, 0, 0, 1");
        }

        if (k[1] != 0.0)
        {
            throw Wrong(matrix, $"'{matrix.Name}' has a skew of {Text(k[1])} px, which {Program} leaves out when it projects. Make it 0, "
                + "or write a camera file with 'skew' (docs/cameras.md)");
        }

        return new ImportedCamera(Program, matrix.Line) { Focal = (k[0], k[4]), Principal = (k[2], k[5]), Size = Size() };
    }

    /// <summary>The numbers of OpenCV's matrices: those below "data", or of a plain list.</summary>
    public double[] MatrixOf(FileTree node) => NumbersOf(node.Find("data") ?? node, 0, int.MaxValue);

    /// <summary>A lens by OpenCV's coefficients.</summary>
    /// <param name="isFisheye">Whether it is the fisheye model.</param>
    /// <param name="node">The coefficients; null for none.</param>
    public IReadOnlyList<(string Key, double[] Numbers, string Word)> Lens(bool isFisheye, FileTree? node)
    {
        double[] k = node is null ? [] : MatrixOf(node);
        return (isFisheye, k.Length) switch
        {
            (true, <= 4) => ImportedCamera.Fisheye(k),
            (false, 0 or 1 or 2 or 4 or 5 or 8 or 12) => ImportedCamera.OpenCv(k),
            (false, 14) when k[12] == 0.0 && k[13] == 0.0 => ImportedCamera.OpenCv(k[..12]),
            (false, 14) => throw Wrong(node!, $"'{node!.Name}' has a tilted sensor (tauX, tauY), which msis can't draw. Calibrate without "
                + "CALIB_TILTED_MODEL"),
            _ => throw Wrong(node!, $"'{node!.Name}' has {k.Length} coefficients; {(isFisheye ? "4" : "4, 5, 8, 12 or 14")} are read"),
        };
    }

    /// <summary>A node that must be there.</summary>
    public FileTree Required(params ReadOnlySpan<string> names)
    {
        if (Root.Find(names) is { } found)
        {
            return found;
        }

        throw Wrong(Root, $"this file of {Program} has no '{names[0]}'. Add it");
    }

    /// <summary>The numbers of a node.</summary>
    public double[] NumbersOf(FileTree node, int min, int max) =>
        node.Numbers() is { } numbers && numbers.Length >= min && numbers.Length <= max ? numbers
        : throw Wrong(node, $"'{node.Name}' needs {(min == max ? $"{min}" : min == 0 ? "finite" : $"{min} to {max}")} numbers");

    /// <summary>The error for a node.</summary>
    /// <param name="why">What is wrong and what to do, without the full stop.</param>
    public BadInputException Wrong(FileTree node, string why) => new($"{Path}, line {node.Line}, column {node.Column}: {why}.");

    /// <summary>The lens by the name that ROS, Kalibr and EuRoC give it.</summary>
    /// <param name="model">The node of the name; null for OpenCV's usual one.</param>
    public IReadOnlyList<(string Key, double[] Numbers, string Word)> NamedLens(FileTree? model, FileTree? coefficients) =>
        model?.Value?.ToLowerInvariant() switch
        {
            null or "" or "plumb_bob" or "rational_polynomial" or "radtan" or "radial-tangential" or "radial_tangential" or "opencv"
                or "thin_prism" => Lens(isFisheye: false, coefficients),
            "equidistant" or "equi" or "fisheye" or "kannala_brandt" => Lens(isFisheye: true, coefficients),
            "none" when coefficients?.Numbers() is not { } numbers || numbers.All(number => number == 0.0) => [],
            "none" => throw Wrong(
                coefficients!, $"the lens is 'none', but '{coefficients!.Name}' are not 0. Name the lens, or make them 0"),
            _ => throw Wrong(model, $"the lens {NumberText.Shown(model.Value)} has no counterpart in msis. Calibrate with plumb_bob "
                    + $"(radtan), "
                + "rational_polynomial or equidistant"),
        };

    private int Whole(FileTree node, double number) => number == Math.Floor(number) && Math.Abs(number) <= int.MaxValue
        ? (int)number
        : throw Wrong(node, $"'{node.Name}' is {Text(number)}; a whole number of px is needed");

    private static string Text(double number) => number.ToString("R", CultureInfo.InvariantCulture);
}

/// <summary>cv::FileStorage in YAML 1.0, XML or JSON.</summary>
/// <remarks>OpenCV 4, core/persistence; the names are those of its calibration samples.</remarks>
internal static class OpenCvFile
{
    private const string Program = "OpenCV";

    private const string Matrices =
        "camera_matrix, cameraMatrix, K, mtx, intrinsic_matrix, intrinsics; of a pair M1 and M2, cameraMatrix1 and "
            + "cameraMatrix2";

    private static readonly (string Name, string[] Matrix, string[] Lens)[] Cameras =
    [
        (
            "1", ["cameramatrix", "k", "intrinsicmatrix", "mtx", "intrinsics"],
            ["distortioncoefficients", "distcoeffs", "d", "dist", "distortion"]),
        ("1", ["m1", "cameramatrix1"], ["d1", "distcoeffs1", "distortioncoefficients1"]),
        ("2", ["m2", "cameramatrix2"], ["d2", "distcoeffs2", "distortioncoefficients2"]),
    ];

    public static bool Is(string text) => text.Contains("<opencv_storage", StringComparison.Ordinal)
        || text.StartsWith("%YAML:1.0", StringComparison.Ordinal) || text.Contains("opencv-matrix", StringComparison.Ordinal);

    public static IReadOnlyList<NamedCamera> Read(string text, string path)
    {
        FileTree root = text.TrimStart() is ['<', ..] ? FileTree.OfXml(text, path)
            : text.TrimStart() is ['{', ..] ? FileTree.OfJson(text, path)
            : FileTree.OfYaml(WithoutDirective(text), path);
        NamedCamera[] found =
        [
            .. Cameras.Where(camera => root.Find(camera.Matrix) is not null)
                .Select(camera => new NamedCamera(camera.Name, () => Camera(root, path, camera.Matrix, camera.Lens))),
        ];
        return found.Length > 0 ? found : throw new BadInputException(
            $"{path}: this file of {Program} has no camera matrix; it may be called {Matrices}.");
    }

    /// <summary>YAML 1.1 knows no directive with a colon; the line stays, empty, for the numbers of the lines.</summary>
    public static string WithoutDirective(string text) =>
        text.StartsWith("%YAML:1.0", StringComparison.Ordinal) ? text[text.IndexOf('\n', StringComparison.Ordinal)..] : text;

    private static ImportedCamera Camera(FileTree root, string path, string[] matrix, string[] lens)
    {
        CalibrationTree tree = new(Program, path, root);
        bool isFisheye = root.Find("distortionmodel") is { } model
            ? model.Value is "fisheye" or "equidistant"
            : root.Find("fisheyemodel") is { } flag && tree.NumbersOf(flag, 1, 1)[0] != 0.0;
        return tree.OfMatrix(root.Find(matrix)!) with { Lens = tree.Lens(isFisheye, root.Find(lens)) };
    }
}

/// <summary>ROS's camera_info: the file of camera_calibration, and the message as the command line prints it.</summary>
/// <remarks>sensor_msgs/CameraInfo, image_pipeline's camera_calibration_parsers. The image is the raw one, before rectification.</remarks>
internal static class RosFile
{
    public static bool Is(string text) => CameraFormats.HasKey(text, "camera_matrix")
        || (CameraFormats.HasKey(text, "[Dd]") && CameraFormats.HasKey(text, "[Kk]"));

    public static IReadOnlyList<NamedCamera> Read(string text, string path)
    {
        CalibrationTree tree = new("ROS", path, FileTree.OfYaml(text, path));
        return [new NamedCamera("1", () => Camera(tree))];
    }

    private static ImportedCamera Camera(CalibrationTree tree)
    {
        foreach (string name in (string[])["binningx", "binningy"])
        {
            if (tree.Root.Find(name) is { } binning && tree.NumbersOf(binning, 1, 1)[0] > 1.0)
            {
                throw tree.Wrong(binning, $"'{binning.Name}' above 1: K is that of the image before binning. Give the calibration without "
                        + $"it");
            }
        }

        if (tree.Root.Find("roi") is { } roi && roi.Items.Any(item => item.Numbers() is [not 0.0]))
        {
            throw tree.Wrong(roi, "'roi' cuts a part out of the image: K is that of the whole. Give the calibration without it");
        }

        return tree.OfMatrix(tree.Required("cameramatrix", "k")) with
        {
            Lens = tree.NamedLens(tree.Root.Find("distortionmodel"), tree.Root.Find("distortioncoefficients", "d")),
        };
    }
}

/// <summary>Kalibr's camchain: a section for each camera.</summary>
/// <remarks>ethz-asl/kalibr, wiki "Yaml formats" and "Supported models".</remarks>
internal static class KalibrFile
{
    public static bool Is(string text) => CameraFormats.HasKey(text, @"cam\d+");

    public static IReadOnlyList<NamedCamera> Read(string text, string path) =>
    [
        .. FileTree.OfYaml(text, path).Items.Where(item => item.Find("intrinsics") is not null)
            .Select(item => new NamedCamera(item.Name, () => Camera(new CalibrationTree("Kalibr", path, item)))),
    ];

    /// <summary>A camera of four intrinsics: fu, fv, pu, pv.</summary>
    public static ImportedCamera Camera(CalibrationTree tree)
    {
        FileTree? model = tree.Root.Find("cameramodel");
        if (model?.Value is { } word && word != "pinhole")
        {
            throw tree.Wrong(model, $"the camera model {NumberText.Shown(word)} has no counterpart in msis. Calibrate with "
                    + $"pinhole-radtan or "
                + "pinhole-equi");
        }

        FileTree intrinsics = tree.Required("intrinsics");
        double[] k = tree.NumbersOf(intrinsics, 4, 4);
        return new ImportedCamera(tree.Program, intrinsics.Line)
        {
            Focal = (k[0], k[1]),
            Principal = (k[2], k[3]),
            Size = tree.Size(),
            Lens = tree.NamedLens(
                tree.Root.Find("distortionmodel"), tree.Root.Find("distortioncoeffs", "distortioncoefficients")),
        };
    }
}

/// <summary>The sensor.yaml of a camera of a data set in EuRoC's form.</summary>
/// <remarks>M. Burri et al., The EuRoC micro aerial vehicle datasets (2016).</remarks>
internal static class EurocFile
{
    public static bool Is(string text) => CameraFormats.HasKey(text, "intrinsics") && CameraFormats.HasKey(text, "camera_model|T_BS");

    public static IReadOnlyList<NamedCamera> Read(string text, string path)
    {
        CalibrationTree tree = new("EuRoC", path, FileTree.OfYaml(OpenCvFile.WithoutDirective(text), path));
        return [new NamedCamera("1", () => KalibrFile.Camera(tree))];
    }
}

/// <summary>The settings of ORB-SLAM 2 and 3: a key for each number.</summary>
/// <remarks>UZ-SLAMLab/ORB_SLAM3, "Calibration tutorial".</remarks>
internal static class OrbSlamFile
{
    public static bool Is(string text) => CameraFormats.HasKey(text, @"Camera1?\.fx");

    public static IReadOnlyList<NamedCamera> Read(string text, string path)
    {
        CalibrationTree tree = new("ORB-SLAM", path, FileTree.OfYaml(OpenCvFile.WithoutDirective(text), path));
        return [new NamedCamera("1", () => Camera(tree))];
    }

    private static ImportedCamera Camera(CalibrationTree tree)
    {
        double Number(string name) => tree.NumbersOf(tree.Required($"camera1{name}", $"camera{name}"), 1, 1)[0];
        double Optional(string name) =>
            tree.Root.Find($"camera1{name}", $"camera{name}") is { } node ? tree.NumbersOf(node, 1, 1)[0] : 0.0;
        FileTree? type = tree.Root.Find("cameratype");
        return new ImportedCamera(tree.Program, tree.Root.Line)
        {
            Focal = (Number("fx"), Number("fy")),
            Principal = (Number("cx"), Number("cy")),
            Size = tree.Size(),
            Lens = type?.Value switch
            {
                null or "PinHole" or "Pinhole" => ImportedCamera.OpenCv(
                    Optional("k1"), Optional("k2"), Optional("p1"), Optional("p2"), Optional("k3")),
                "KannalaBrandt8" => ImportedCamera.Fisheye(Optional("k1"), Optional("k2"), Optional("k3"), Optional("k4")),
                var word => throw tree.Wrong(type, $"{NumberText.Shown(word)} is not the raw image of a PinHole or KannalaBrandt8 camera"),
            },
        };
    }
}
