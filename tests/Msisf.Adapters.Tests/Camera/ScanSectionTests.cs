using System.Text;
using Msisf.Adapters.Camera;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Camera;

public sealed class ScanSectionTests
{
    private const string Head = "width: 64\nfocal-length: 10\npixel-pitch: 0.01\n";

    private const string Detector =
        "detector:\n  f-number: 4\n  exposure-time: 0.001\n  band: [500, 600]\n  quantum-efficiency: 0.5\n  gain: 10\n  adc-bits: 12\n";

    [Fact]
    public void Parse_LineScan_IsRead() => Assert.Equal(
        new CameraFileScan(ScanKind.LineScan, 0.25) { Stages = 4, ChargeMovesDown = false, GrowsUpwards = true },
        Scan($"{Head}height: 4\n{Detector}scan:\n  kind: line-scan\n  period: 0.25\n  tdi: 4\n  tdi-direction: up\n  order: up\n"));

    [Fact]
    public void Parse_PushFrame_IsRead() => Assert.Equal(
        new CameraFileScan(ScanKind.PushFrame, null) { Framelet = new PixelRows(1, 4), FlipsFramelets = true },
        Scan($"{Head}height: 4\nscan:\n  kind: push-frame\n  framelet: [2, 3]\n  flip: yes\n"));

    [Fact]
    public void Parse_NoSection_IsAFrame() => Assert.Null(Scan($"{Head}height: 4\n"));

    [Fact]
    public void Parse_RollingShutterOfTheDetector_IsRefused()
    {
        string text = $"{Head}height: 1\n{Detector}  shutter: rolling\n  line-time: 0.01\nscan:\n  kind: line-scan\n";
        Assert.Contains(
            "'scan' and the detector's rolling 'shutter' both say when rows are exposed.",
            Assert.Throws<BadInputException>(() => Scan(text)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(
        "height: 1\nscan:\n  period: 1\n",
        "line 5, column 1: a scan needs 'kind': what an exposure adds to the image: line-scan, push")]
    [InlineData(
        "height: 1\nscan:\n  kind: line\n",
        "line 6, column 3: 'kind' is 'line'; one of line-scan, push-frame, rolling-shutter is needed")]
    [InlineData("height: 1\nscan:\n  kind: line-scan\n  period: 0\n", "line 7, column 3: 'period' is 0; a number above 0 is needed.")]
    [InlineData("height: 2\nscan:\n  kind: line-scan\n", "line 4, column 1: 'height' is 2, and a line-scan camera has one row.")]
    [InlineData(
        "height: 2\nscan:\n  kind: line-scan\n  tdi: 2\n",
        "line 7, column 3: 'tdi' adds electrons and needs the section 'detector'.")]
    [InlineData(
        "height: 2\nscan:\n  kind: line-scan\n  tdi: 3\n",
        "line 4, column 1: 'height' is 2, and 'tdi' adds the electrons of 3 rows.")]
    [InlineData("height: 1\nscan:\n  kind: line-scan\n  tdi-direction: up\n", "'tdi-direction' has no meaning without 'tdi'.")]
    [InlineData(
        "height: 1\nscan:\n  kind: line-scan\n  flip: yes\n",
        "line 7, column 3: 'flip' has no meaning for kind line-scan. Leave it out.")]
    [InlineData(
        "height: 4\nscan:\n  kind: push-frame\n  framelet: [2, 4]\n",
        "'framelet' is 4 rows from row 2 on, and the detector has rows 1 to 4.")]
    [InlineData("height: 4\nscan:\n  kind: push-frame\n  framelet: [0, 4]\n", "'framelet' is 4 rows from row 0 on")]
    [InlineData("height: 4\nscan:\n  kind: push-frame\n  framelet: [1, 2.5]\n", "'framelet' is 2.5 rows from row 1 on")]
    [InlineData(
        "height: 4\nscan:\n  kind: rolling-shutter\n",
        "line 5, column 1: a scan needs 'period': s from the exposure of a row to that")]
    public void Parse_Wrong_SaysWhere(string lines, string message) =>
        Assert.Contains(message, Assert.Throws<BadInputException>(() => Scan(Head + lines)).Message, StringComparison.Ordinal);

    private static CameraFileScan? Scan(string text) => CameraFileReader.Parse(Encoding.UTF8.GetBytes(text), "c.yaml").Scan;
}
