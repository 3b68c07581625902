namespace Msisf.App.Settings;

/// <summary>File formats of flows.</summary>
[Flags]
internal enum FlowFormats
{
    None = 0,
    Fits = 1,
    Npy = 2,
    Middlebury = 4,
    Kitti = 8,
}
