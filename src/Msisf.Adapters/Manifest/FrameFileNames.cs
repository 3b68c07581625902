using Msisf.Adapters.CameraExport;
using Msisf.Adapters.Maps;
using Msisf.Core.Layers;
using Msisf.Core.Sensitivity;

namespace Msisf.Adapters.Manifest;

/// <summary>The names that the files of a frame can have: the frame's name, and an ending for each kind of file.</summary>
public static class FrameFileNames
{
    /// <summary>All endings, whatever a run was asked to write.</summary>
    private static readonly string[] Endings =
    [
        ".png", ".annotated.png", ".pov", ".xml", ".fits", ".dn.fits", ".layers.json", ".rowstates.npy", ".craters.csv", ".craters.json",
        ".landmarks.csv", ".stars.csv", ".bodies.csv", ".information.csv", ".sensitivity.fits", ".sensitivity.layers.json",
        ".certain.fits", ".certain.layers.json",
        ".flow.fits", ".flow.npy", ".flow-class.npy", ".flow-light.npy", ".flow.json", ".flow.flo", ".flow.png", ".stereo.fits",
        ".disparity.npy", ".disparity-class.npy", ".stereo.json", ".disparity.png",
        .. ImageMapFiles.Endings, .. CameraFormat.All.SelectMany(format => format.Endings),
        .. LayerCatalogue.All.Select(layer => $".{layer.Name}.npy"),
        .. CertainLayers.Names.Select(name => $".certain.{name}.npy"),
        .. Parameter.All.Select(parameter => $".sensitivity.{SensitivityLayers.NameOf(parameter)}.npy"),
    ];

    /// <summary>All names that files of a frame can have.</summary>
    public static IEnumerable<string> Of(string frame) => Endings.Select(ending => frame + ending);

    /// <summary>Whether a file may be made of a frame that is there, by msis camera-model, so that no record names it.</summary>
    /// <param name="file">Name of the file, without folder.</param>
    public static bool IsMadeLater(string file) =>
        CameraFormat.All.SelectMany(format => format.Endings).Any(ending => file.EndsWith(ending, StringComparison.Ordinal));

    /// <summary>The names of the frames that a file could belong to by its name.</summary>
    /// <param name="file">Name of the file, without folder.</param>
    public static IEnumerable<string> FramesOf(string file) => Endings
        .Where(ending => file.EndsWith(ending, StringComparison.Ordinal))
        .Select(ending => file[..^ending.Length]);
}
