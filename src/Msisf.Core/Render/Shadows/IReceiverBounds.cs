namespace Msisf.Core.Render.Shadows;

/// <summary>Where the points are on which a shadow may be seen.</summary>
internal interface IReceiverBounds
{
    /// <summary>Light space.</summary>
    LightFrame Frame { get; }

    /// <summary>Bounds of all points, m; empty if there are none.</summary>
    LightBox Box { get; }

    /// <summary>Maximum depth of all points, m; minus infinity if there are none.</summary>
    double MaxDepth { get; }

    /// <summary>Upper bound of the depths of the points in a box, m; minus infinity if there are none.</summary>
    double MaxDepthIn(in LightBox box);
}
